// SPDX-License-Identifier: Apache-2.0
#include "last_metres/nimbleness.hpp"

namespace krait::detail {
namespace {

// Measured: bench/ABLATIONS.md, "Constants".
constexpr float kSettle = 3.0F;  // time steps in which the remaining way shrinks by e, at most

}  // namespace

float pace(const Nimbleness& robot, float remaining, float speed, float stopping_way, float braking, float slowest) {
  const float way = math::absolute(stopping_way);
  float wanted = remaining / (kSettle * robot.dt);
  if (way > 0.0F) {
    const float fastest = speed * std::sqrt(braking * remaining / way);
    if (fastest < wanted) wanted = fastest;
  }
  return math::clamp(wanted / robot.top_speed, slowest, 1.0F);
}

}  // namespace krait::detail
