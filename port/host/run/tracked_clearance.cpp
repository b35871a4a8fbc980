// SPDX-License-Identifier: Apache-2.0
#include "host/run/tracked_clearance.hpp"

#include <algorithm>

namespace krait::host {

double tracked_clearance(const RobotSpec& robot, const Workspace* map) {
  constexpr double kShare = 0.02;
  double widest = 0;
  for (const Ring& body : robot.bodies) {
    const auto by_y = [](const Point& a, const Point& b) { return a.y < b.y; };
    const auto [right, left] = std::minmax_element(body.begin(), body.end(), by_y);
    widest = std::max(widest, left->y - right->y);
  }
  return kShare * widest + (map != nullptr && map->cells ? map->cells->resolution / 2 : 0);
}

}  // namespace krait::host
