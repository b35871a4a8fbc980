// SPDX-License-Identifier: Apache-2.0
#include "scene/cells.hpp"

#include <algorithm>

namespace krait::detail {
namespace {

// Rounded down and up; b > 0.
template <class Integer>
Integer floor_divided(Integer a, Integer b) {
  return a / b - (a % b < 0 ? 1 : 0);
}
template <class Integer>
Integer ceil_divided(Integer a, Integer b) {
  return a / b + (a % b > 0 ? 1 : 0);
}

// The part of a convex polygon within a strip of constant y: its extent in x, rounded inwards to the grid, which
// misses no cell, since cells begin and end on the grid.
struct Extent {
  std::int32_t low = INT32_MAX;
  std::int32_t high = INT32_MIN;

  void add(std::int32_t floor, std::int32_t ceil) {
    low = std::min(low, ceil);
    high = std::max(high, floor);
  }
  // The point of the edge from `from` up to `to` at height y.
  void add(GridPoint from, GridPoint to, std::int32_t y) {
    if (y == from.y) return add(from.x, from.x);
    if (y == to.y) return add(to.x, to.x);
    const std::int64_t rise = to.y - from.y;
    const std::int64_t along = std::int64_t{to.x - from.x} * (y - from.y);
    add(from.x + static_cast<std::int32_t>(floor_divided(along, rise)),
        from.x + static_cast<std::int32_t>(ceil_divided(along, rise)));
  }
};

}  // namespace

CellSpan CellSquares::span(std::int32_t low, std::int32_t high, std::int32_t cells) const {
  return {std::max(std::int32_t{0}, ceil_divided(low - kMargin, size_) - 1),
          std::min(cells - 1, floor_divided(high + kMargin, size_))};
}

CellSpan CellSquares::columns_of(const GridPolygon& polygon, std::int32_t row) const {
  const GridBox strip = square(0, row);
  Extent extent;
  for (int i = 0; i < polygon.count; ++i) {
    GridPoint from = polygon[i];
    GridPoint to = polygon.after(i);
    if (from.y > to.y) {
      const GridPoint upper = from;
      from = to;
      to = upper;
    }
    if (to.y < strip.min.y || from.y > strip.max.y) continue;
    extent.add(from, to, std::max(from.y, strip.min.y));
    extent.add(from, to, std::min(to.y, strip.max.y));
  }
  return extent.low == INT32_MAX ? CellSpan{} : columns_between(extent.low, extent.high);
}

}  // namespace krait::detail
