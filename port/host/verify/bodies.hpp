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

// Without the care of std::hypot for numbers near the ends of their range, which costs five times as much.
inline double distance(const Point& a, const Point& b) {
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

inline double gap(const Frame& a, const Frame& b) { return distance(a.origin, b.origin); }

// Visits each pair of bodies that must not meet.
template <typename Visit>
void for_each_pair(const Dynamics& dynamics, const Visit& visit) {
  const std::size_t apart = dynamics.self_collision_gap();
  for (std::size_t first = 0; apart > 0 && first < dynamics.body_count(); ++first) {
    for (std::size_t second = first + apart; second < dynamics.body_count(); ++second) visit(first, second);
  }
}

}  // namespace krait::host
