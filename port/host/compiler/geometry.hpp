// SPDX-License-Identifier: GPL-3.0-or-later
// Points on the scene's grid and the edges between them: every predicate is exact in 64-bit integers.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <vector>

namespace krait::host::compiler {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// In steps of format::kGrid from the local origin; at most 2^23 in absolute value.
struct GridPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  auto operator<=>(const GridPoint&) const = default;
};

using GridRing = std::vector<GridPoint>;  // closed implicitly

struct GridBox {
  GridPoint min;
  GridPoint max;
};

// Whether a point, GridPoint or Point in grid steps, lies in the box or on its border.
template <class P>
bool within(const P& p, const GridBox& b) {
  return p.x >= b.min.x && p.x <= b.max.x && p.y >= b.min.y && p.y <= b.max.y;
}

// The smallest box that contains both.
inline GridBox extended(const GridBox& box, GridPoint p) {
  return {{std::min(box.min.x, p.x), std::min(box.min.y, p.y)}, {std::max(box.max.x, p.x), std::max(box.max.y, p.y)}};
}

// The smallest box around points, of which there must be one.
inline GridBox box_of(const std::vector<GridPoint>& points) {
  GridBox box{points.front(), points.front()};
  for (const GridPoint p : points) box = extended(box, p);
  return box;
}

// Winding numbers of a place, by two independent sets of rings.
using Winding = std::array<std::int32_t, 2>;

// The place left of the edge has the winding of the place right of it plus `winding`.
struct Edge {
  GridPoint from;
  GridPoint to;
  Winding winding = {1, 0};
};

using Edges = std::vector<Edge>;

// Whether the edge lies along one of the box's sides.
inline bool on_border(const Edge& e, const GridBox& b) {
  return (e.from.x == e.to.x && (e.from.x == b.min.x || e.from.x == b.max.x)) ||
         (e.from.y == e.to.y && (e.from.y == b.min.y || e.from.y == b.max.y));
}

// Twice the signed area of the triangle: positive if it turns left.
inline std::int64_t cross(GridPoint a, GridPoint b, GridPoint c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

inline std::int64_t dot(GridPoint a, GridPoint b, GridPoint c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.x} - a.x) + (std::int64_t{b.y} - a.y) * (std::int64_t{c.y} - a.y);
}

inline std::int64_t twice_area(const GridRing& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) sum += cross(ring[0], ring[i - 1], ring[i]);
  return sum;
}

// Appends the ring's edges; zero-length ones are left out.
inline void append_ring(Edges& edges, const GridRing& ring, Winding winding) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPoint next = ring[(i + 1) % ring.size()];
    if (ring[i] != next) edges.push_back({ring[i], next, winding});
  }
}

inline Edges edges_of(const std::vector<GridRing>& rings) {
  Edges edges;
  for (const GridRing& ring : rings) append_ring(edges, ring, {1, 0});
  return edges;
}

inline GridRing ring_of(const GridBox& box) {
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

}  // namespace krait::host::compiler
