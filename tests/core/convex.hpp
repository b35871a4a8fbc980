// SPDX-License-Identifier: Apache-2.0
// Convex polygons for the collision tests: random ones, and their separation in double precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "draws.hpp"
#include "scene_builder.hpp"

namespace krait::test {

// Strictly convex, counter-clockwise, 3 to 8 vertices of the grid on an ellipse around the centre, of half axes 0.2 to
// `size` metres.
inline std::vector<Vec2> random_convex(std::mt19937& random, Point center, double size) {
  const int count = 3 + static_cast<int>(below(random, 6));
  const double a = uniform(random, 0.2, size), b = uniform(random, 0.2, size), turn = uniform(random, 0, 6.28);
  const double first = uniform(random, 0, 6.28);
  std::vector<Vec2> result;
  for (int i = 0; i < count; ++i) {
    const double angle = first + 6.283185307 * (i + uniform(random, 0, 0.6)) / count;
    const double x = a * std::cos(angle), y = b * std::sin(angle);
    result.push_back({snap(center.x + x * std::cos(turn) - y * std::sin(turn)),
                      snap(center.y + x * std::sin(turn) + y * std::cos(turn))});
  }
  return result;
}

// Largest gap between the polygons along the normal of any of their sides: positive exactly when they are apart, and
// then at most their distance.
inline double separation(const Ring& a, const Ring& b) {
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& [one, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    for (std::size_t i = 0; i < one->size(); ++i) {
      const Point from = (*one)[i], to = (*one)[(i + 1) % one->size()];
      double least = std::numeric_limits<double>::infinity();
      for (const Point p : *other) least = std::min(least, -side(from, to, p));
      most = std::max(most, least / std::hypot(to.x - from.x, to.y - from.y));
    }
  }
  return most;
}

// Exact distance of two convex polygons, 0 when they touch or overlap.
inline double distance(const Ring& a, const Ring& b) {
  if (separation(a, b) <= 0) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Point p : a) least = std::min(least, distance_to_convex(p, b));
  for (const Point p : b) least = std::min(least, distance_to_convex(p, a));
  return least;
}

// From a convex polygon inside the bounds to their sides; negative when it reaches beyond.
inline double room_inside(const Ring& ring, const Rect& bounds) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point p : ring) {
    least = std::min({least, p.x - bounds.x0, bounds.x1 - p.x, p.y - bounds.y0, bounds.y1 - p.y});
  }
  return least;
}

}  // namespace krait::test
