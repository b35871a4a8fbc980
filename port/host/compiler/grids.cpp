// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/grids.hpp"

#include <algorithm>
#include <cmath>

#include "krait/format.hpp"

namespace krait::host::compiler {
namespace {

// Calls visit(column, row) for every cell whose widened square meets the closed box.
template <class Visit>
void cells_meeting(const GridShape& s, const GridBox& box, Visit visit) {
  const auto number = [&](std::int32_t at, std::int32_t min, std::int32_t cells) {
    return std::clamp(at < min ? -1 : (at - min) / s.size, -1, cells);
  };
  const auto first = [&](std::int32_t low, std::int32_t min, std::int32_t cells) {
    return std::max(0, number(low - kCellMargin - 1, min, cells));
  };
  const auto last = [&](std::int32_t high, std::int32_t min, std::int32_t cells) {
    return std::min(cells - 1, number(high + kCellMargin, min, cells));
  };
  const std::int32_t right = last(box.max.x, s.bounds.min.x, s.columns),
                     above = last(box.max.y, s.bounds.min.y, s.rows);
  for (std::int32_t row = first(box.min.y, s.bounds.min.y, s.rows); row <= above; ++row) {
    for (std::int32_t column = first(box.min.x, s.bounds.min.x, s.columns); column <= right; ++column)
      visit(column, row);
  }
}

// Whether the box, which meets the ring's own box, lies wholly outside one of the convex ring's edges.
bool beyond_an_edge(const GridRing& ring, const GridBox& box) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    const GridPoint leftmost{b.y >= a.y ? box.min.x : box.max.x, b.x >= a.x ? box.max.y : box.min.y};
    if (cross(a, b, leftmost) < 0) return true;
  }
  return false;
}

std::uint32_t cell_number(const GridShape& s, std::int32_t column, std::int32_t row) {
  return static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(s.columns) + static_cast<std::uint32_t>(column);
}

// Lowers bytes that are over a neighbour's by more than a cell: forth for the neighbours before, back for those behind.
void limit_steps(const GridShape& shape, std::vector<std::uint8_t>& bytes) {
  const auto limit = [&](std::int32_t column, std::int32_t row, int sign) {
    std::uint8_t& here = bytes[cell_number(shape, column, row)];
    const auto by = [&](std::int32_t x, std::int32_t y) {
      if (x < 0 || y < 0 || x >= shape.columns || y >= shape.rows) return;
      const int most = bytes[cell_number(shape, x, y)] + format::kClearanceUnits;
      if (here > most) here = static_cast<std::uint8_t>(most);
    };
    by(column - sign, row);
    for (std::int32_t x = column - 1; x <= column + 1; ++x) by(x, row - sign);
  };
  for (std::int32_t row = 0; row < shape.rows; ++row) {
    for (std::int32_t column = 0; column < shape.columns; ++column) limit(column, row, 1);
  }
  for (std::int32_t row = shape.rows - 1; row >= 0; --row) {
    for (std::int32_t column = shape.columns - 1; column >= 0; --column) limit(column, row, -1);
  }
}

}  // namespace

GridBox GridShape::cell(std::int32_t column, std::int32_t row) const {
  const GridPoint min{bounds.min.x + column * size, bounds.min.y + row * size};
  return {{min.x - kCellMargin, min.y - kCellMargin}, {min.x + size + kCellMargin, min.y + size + kCellMargin}};
}

GridShape grid_shape(const GridBox& bounds, double size, std::int32_t multiple) {
  const std::int32_t width = bounds.max.x - bounds.min.x, height = bounds.max.y - bounds.min.y;
  GridShape shape;
  shape.bounds = bounds;
  double wanted = std::clamp(size, 1.0, double(std::max(width, height)));
  do {
    shape.size = static_cast<std::int32_t>(std::ceil(wanted / multiple)) * multiple;
    shape.columns = (width + shape.size - 1) / shape.size;
    shape.rows = (height + shape.size - 1) / shape.size;
    wanted = shape.size * 1.02 + 1;
  } while (shape.cells() > kMostCells);
  return shape;
}

CellLists bucket_triangles(const GridShape& shape, const std::vector<GridRing>& triangles) {
  return {shape.cells(), [&](auto emit) {
            for (std::uint32_t i = 0; i < triangles.size(); ++i) {
              cells_meeting(shape, box_of(triangles[i]), [&](std::int32_t column, std::int32_t row) {
                if (!beyond_an_edge(triangles[i], shape.cell(column, row))) emit(cell_number(shape, column, row), i);
              });
            }
          }};
}

CellLists bucket_pieces(const GridShape& shape, const std::vector<GridBox>& boxes) {
  return {shape.cells(), [&](auto emit) {
            for (std::uint32_t i = 0; i < boxes.size(); ++i) {
              cells_meeting(shape, boxes[i],
                            [&](std::int32_t column, std::int32_t row) { emit(cell_number(shape, column, row), i); });
            }
          }};
}

std::vector<std::uint8_t> clearances(const GridShape& shape, double unit, const Distances& boundary,
                                     const std::vector<GridRing>& pieces) {
  std::vector<bool> solid(shape.cells(), false);
  for (const GridRing& piece : pieces) {
    cells_meeting(shape, box_of(piece), [&](std::int32_t column, std::int32_t row) {
      if (!beyond_an_edge(piece, shape.cell(column, row))) solid[cell_number(shape, column, row)] = true;
    });
  }
  std::vector<std::uint8_t> bytes(shape.cells(), 0);
  for (std::int32_t row = 0; row < shape.rows; ++row) {
    for (std::int32_t column = 0; column < shape.columns; ++column) {
      const std::uint32_t number = cell_number(shape, column, row);
      if (solid[number]) continue;
      // Half a step pays for the rounding of the distance.
      const double distance = boundary.to_box(shape.cell(column, row)) - 0.5;
      bytes[number] = static_cast<std::uint8_t>(std::clamp(distance / unit, 0.0, double(format::kMaxClearance)));
    }
  }
  limit_steps(shape, bytes);
  return bytes;
}

}  // namespace krait::host::compiler
