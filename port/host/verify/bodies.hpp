// SPDX-License-Identifier: Apache-2.0
// What several checks ask of a robot's bodies.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "host/verify/dynamics.hpp"

namespace krait::host {

// How far each body reaches from its frame's origin.
inline std::vector<double> radii_of(const RobotSpec& robot) {
  std::vector<double> radii;
  for (const Ring& body : robot.bodies) {
    double radius = 0;
    for (const Point& point : body) radius = std::max(radius, std::hypot(point.x, point.y));
    radii.push_back(radius);
  }
  return radii;
}

inline double gap(const Frame& a, const Frame& b) {
  return std::hypot(a.origin.x - b.origin.x, a.origin.y - b.origin.y);
}

// Visits each pair of bodies that must not meet.
template <typename Visit>
void for_each_pair(const Dynamics& dynamics, const Visit& visit) {
  const std::size_t apart = dynamics.self_collision_gap();
  for (std::size_t first = 0; apart > 0 && first < dynamics.body_count(); ++first) {
    for (std::size_t second = first + apart; second < dynamics.body_count(); ++second) visit(first, second);
  }
}

}  // namespace krait::host
