// SPDX-License-Identifier: Apache-2.0
// What keeps a state inside the limits of its speeds while it is steered.
#pragma once

#include "krait/geometry.hpp"

namespace krait::detail {

inline constexpr float kInside = 1.0F - 1e-5F;  // keeps rounding from carrying a state across its limit

// The speed nearest to that within limits which rounding does not carry it across.
[[gnu::always_inline]] inline float inside(float speed, float least, float most) {
  const float inset = (1.0F - kInside) * (most - least);
  return math::clamp(speed, least + inset, most - inset);
}

}  // namespace krait::detail
