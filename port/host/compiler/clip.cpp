// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/clip.hpp"

#include <algorithm>
#include <cmath>

#include "host/workspace/ring.hpp"

namespace krait::host::compiler {
namespace {

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
