// SPDX-License-Identifier: Apache-2.0
// Points of bodies; areas of rings, by their signs, their parts on one side of a line, and whether two are one.
#pragma once

#include <algorithm>
#include <cmath>

#include "host/workspace/workspace.hpp"

namespace krait::host {

// What is given in the frame of a body that has this origin and this heading, radians.
inline Point placed(const Point& p, const Point& origin, double heading) {
  const double c = std::cos(heading), s = std::sin(heading);
  return {origin.x + c * p.x - s * p.y, origin.y + s * p.x + c * p.y};
}

inline Ring placed(const Ring& ring, const Point& origin, double heading) {
  Ring result;
  for (const Point& p : ring) result.push_back(placed(p, origin, heading));
  return result;
}

// Twice the area of the triangle, above 0 where it is counter-clockwise.
inline double cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Twice the ring's area, above 0 where it is counter-clockwise; a ring of fewer than three points has none.
inline double twice_area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += cross(ring[0], ring[i], ring[i + 1]);
  return sum;
}

// The part of the ring where depth(p) >= 0, on one side of a line (Sutherland and Hodgman 1974). Winding numbers there
// stay as they were.
template <class Depth>
Ring clip(const Ring& ring, Depth depth) {
  Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const double da = depth(a), db = depth(b);
    if (da >= 0) kept.push_back(a);
    if ((da < 0) != (db < 0)) {
      const double t = da / (da - db);
      kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  return kept;
}

// Whether both have the same points in the same order.
inline bool same_ring(const Ring& a, const Ring& b) {
  const auto same = [](const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

}  // namespace krait::host
