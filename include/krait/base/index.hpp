// SPDX-License-Identifier: Apache-2.0
// Numbers of triangles, regions, vertices and whatever else stands in an array.
#pragma once

#include <cstdint>

namespace krait {

using Index = std::uint32_t;
inline constexpr Index kNone = 0xFFFFFFFF;
inline constexpr std::uint16_t kNone16 = 0xFFFF;  // where two bytes are enough for each

}  // namespace krait
