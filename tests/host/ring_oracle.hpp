// SPDX-License-Identifier: Apache-2.0
// Distances to rings, and what rings go around, by brute force.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/workspace/workspace.hpp"

namespace krait::host::test {

inline double distance(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double t = squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

inline double distance(Point p, const Ring& ring) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i)
    nearest = std::min(nearest, distance(p, ring[i], ring[(i + 1) % ring.size()]));
  return nearest;
}

// Winding number by crossings of the ray to the right.
inline int winding(Point p, const Ring& ring) {
  int count = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    if (a.y <= p.y && b.y > p.y && side > 0) ++count;
    if (a.y > p.y && b.y <= p.y && side < 0) --count;
  }
  return count;
}

}  // namespace krait::host::test
