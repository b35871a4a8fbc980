// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/clip.hpp"

#include <algorithm>
#include <cmath>

namespace krait::host::compiler {
namespace {

// The part of the ring on one side of a line (Sutherland and Hodgman 1974); windings within stay the same.
// depth(p) >= 0 is kept.
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

// In grid steps, local.
GridRing placed(Ring ring, const GridBox& b) {
  ring = clip(ring, [&](Point p) { return p.x - b.min.x; });
  ring = clip(ring, [&](Point p) { return b.max.x - p.x; });
  ring = clip(ring, [&](Point p) { return p.y - b.min.y; });
  ring = clip(ring, [&](Point p) { return b.max.y - p.y; });
  GridRing placed;
  for (const Point p : ring) {
    const GridPoint q{std::clamp(static_cast<std::int32_t>(std::lround(p.x)), b.min.x, b.max.x),
                      std::clamp(static_cast<std::int32_t>(std::lround(p.y)), b.min.y, b.max.y)};
    if (placed.empty() || placed.back() != q) placed.push_back(q);
  }
  while (placed.size() > 1 && placed.front() == placed.back()) placed.pop_back();
  return placed;
}

}  // namespace

GridRing place_within(const Ring& world, const Frame& frame) {
  Ring ring;
  for (const Point p : world) ring.push_back(frame.local(p));
  return placed(std::move(ring), frame.bounds);
}

GridRing clip_within(const GridRing& ring, const GridBox& bounds) {
  Ring local;
  for (const GridPoint p : ring) local.push_back({double(p.x), double(p.y)});
  return placed(std::move(local), bounds);
}

void check_finite(const Ring& ring, const std::string& label) {
  for (const Point p : ring) {
    // Beyond 1e9 m the products of clipping lose what lies within the bounds.
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || std::abs(p.x) > 1e9 || std::abs(p.y) > 1e9) {
      throw InputError(label + ": a coordinate is not a finite number below 1e9 m");
    }
  }
}

}  // namespace krait::host::compiler
