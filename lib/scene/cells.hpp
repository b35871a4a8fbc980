// SPDX-License-Identifier: Apache-2.0
// Which cells of a bucket or clearance grid a box or a convex polygon meets, in exact integers.
#pragma once

#include <algorithm>

#include "krait/scene.hpp"
#include "scene/grid_point.hpp"

namespace krait::detail {

// Columns or rows from first to last; none when last < first.
struct CellSpan {
  std::int32_t first = 0;
  std::int32_t last = -1;

  bool holds(std::int32_t i) const { return i >= first && i <= last; }
  std::uint64_t count() const { return last < first ? 0U : static_cast<std::uint64_t>(last - first) + 1; }
};

struct GridBox {
  GridPoint min;
  GridPoint max;
};

// A triangle or a piece in grid coordinates, and the box around it.
struct GridPolygon {
  GridPoint vertices[format::kMaxPieceVertices];
  int count;
  GridBox box;

  explicit GridPolygon(Polygon polygon) : count(polygon.count) {
    for (int i = 0; i < count; ++i) vertices[i] = to_grid(polygon[i]);
    const Box around = bounding_box(polygon);
    box = {to_grid(around.min), to_grid(around.max)};
  }
  GridPoint operator[](int i) const { return vertices[i]; }
  GridPoint after(int i) const { return vertices[i + 1 < count ? i + 1 : 0]; }
};

// Square cells from the bounds' minimum, each widened by format::kCellMargin; all in grid coordinates.
class CellSquares {
 public:
  CellSquares(const Box& bounds, float size, std::uint32_t columns, std::uint32_t rows)
      : bounds_{to_grid(bounds.min), to_grid(bounds.max)},
        size_(grid_steps(size)),
        columns_(static_cast<std::int32_t>(columns)),
        rows_(static_cast<std::int32_t>(rows)) {}

  std::int32_t size() const { return size_; }
  std::int32_t columns() const { return columns_; }
  std::int32_t rows() const { return rows_; }
  std::size_t number(std::int32_t column, std::int32_t row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  GridBox square(std::int32_t column, std::int32_t row) const {
    const GridPoint low{bounds_.min.x + column * size_ - kMargin, bounds_.min.y + row * size_ - kMargin};
    return {low, {low.x + size_ + 2 * kMargin, low.y + size_ + 2 * kMargin}};
  }

  // The columns and rows that reach from `low` to `high` meets.
  CellSpan columns_between(std::int32_t low, std::int32_t high) const {
    return span(low - bounds_.min.x, high - bounds_.min.x, columns_);
  }
  CellSpan rows_between(std::int32_t low, std::int32_t high) const {
    return span(low - bounds_.min.y, high - bounds_.min.y, rows_);
  }

  // The columns of `row` where its squares meet the convex polygon. O(vertices).
  CellSpan columns_of(const GridPolygon& polygon, std::int32_t row) const;

  // Grid steps from the squares of a column or a row to the nearer of the two bounds beside it; not above 0 where they
  // reach one.
  std::int32_t column_to_bounds(std::int32_t column) const {
    return to_ends(column * size_, bounds_.max.x - bounds_.min.x);
  }
  std::int32_t row_to_bounds(std::int32_t row) const { return to_ends(row * size_, bounds_.max.y - bounds_.min.y); }

 private:
  static constexpr std::int32_t kMargin = format::kCellMargin;

  CellSpan span(std::int32_t low, std::int32_t high, std::int32_t cells) const;
  std::int32_t to_ends(std::int32_t low, std::int32_t length) const {
    const std::int32_t before = low - kMargin;
    const std::int32_t after = length - (low + size_ + kMargin);
    return std::min(after, before);
  }

  GridBox bounds_;
  std::int32_t size_;
  std::int32_t columns_;
  std::int32_t rows_;
};

}  // namespace krait::detail
