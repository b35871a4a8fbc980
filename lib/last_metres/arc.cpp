// SPDX-License-Identifier: Apache-2.0
#include "last_metres/arc.hpp"

namespace krait::detail {

Pose along(const Pose& from, int turn, float radius, float way) {
  if (turn == 0) return {from.position + way * direction(from.heading), from.heading};
  const auto side = static_cast<float>(turn);
  const SinCos heading = from.heading + math::sin_cos(side * way / radius);
  return {from.position + side * radius * (left_of(direction(from.heading)) - left_of(direction(heading))), heading};
}

}  // namespace krait::detail
