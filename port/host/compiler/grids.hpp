// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's two uniform grids: buckets for location and candidates, and clearances.
#pragma once

#include <vector>

#include "host/compiler/cell_index.hpp"
#include "host/compiler/distances.hpp"
#include "host/compiler/geometry.hpp"
#include "krait/format.hpp"

namespace krait::host::compiler {

// Square cells from the bounds' minimum, enough to cover them.
struct GridShape {
  GridBox bounds;
  std::int32_t size = 1;  // grid steps
  std::int32_t columns = 1;
  std::int32_t rows = 1;

  std::size_t cells() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  // Widened by kCellMargin.
  GridBox cell(std::int32_t column, std::int32_t row) const;
};

inline constexpr std::size_t kMostCells = format::kMaxCells;

// Cells no smaller than `size`, a multiple of `multiple`, and at most kMostCells of them.
GridShape grid_shape(const GridBox& bounds, double size, std::int32_t multiple);

// A reader may find a point's cell in float: up to this many grid steps past the cell's border still count as within.
inline constexpr std::int32_t kCellMargin = format::kCellMargin;

// By cell, the triangles and the pieces' boxes that meet its square, widened by kCellMargin; ascending.
CellLists bucket_triangles(const GridShape& shape, const std::vector<GridRing>& triangles);
CellLists bucket_pieces(const GridShape& shape, const std::vector<GridBox>& boxes);

// By cell, row-major: floor of a lower bound of the distance from any point of its widened square to the
// boundary, in units of `unit` grid steps, at most 255 and at most a cell more than at any of the eight neighbours;
// 0 where that meets the boundary or a piece.
std::vector<std::uint8_t> clearances(const GridShape& shape, double unit, const Distances& boundary,
                                     const std::vector<GridRing>& pieces);

}  // namespace krait::host::compiler
