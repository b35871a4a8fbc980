// SPDX-License-Identifier: Apache-2.0
// The cells of a map by number, those around a place and those around a cell.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "host/workspace/cell_frame.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

inline constexpr double kCellRounding = 1e-6;  // of a cell: what decimals lose in double arithmetic

inline std::size_t cell_number(const CellMap& map, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) + static_cast<std::size_t>(column);
}

// The middle of a cell in the world.
inline Point middle(const CellMap& map, const CellFrame& frame, std::size_t cell) {
  const auto columns = static_cast<std::size_t>(map.columns);
  return frame.world(double(cell % columns) + 0.5, double(cell / columns) + 0.5);
}

// The cell that holds the place in the world; nothing off the map.
inline std::optional<std::size_t> cell_at(const CellMap& map, const CellFrame& frame, Point world) {
  const Point p = frame.cells(world);
  if (!(p.x >= 0 && p.y >= 0 && p.x < map.columns && p.y < map.rows)) return std::nullopt;
  return cell_number(map, static_cast<int>(p.x), static_cast<int>(p.y));
}

// Calls visit(cell) for the cells that come within `reach` metres of the place.
template <class Visit>
void each_around(const CellMap& map, Point world, double reach, Visit visit) {
  const Point p = CellFrame(map).cells(world);
  const double r = reach / map.resolution + kCellRounding;
  const auto limited = [](double at, int cells) { return static_cast<int>(std::clamp(at, 0.0, double(cells))); };
  const auto gap = [](double at, int cell) { return std::max({0.0, cell - at, at - cell - 1}); };
  for (int row = limited(p.y - r - 1, map.rows); row < limited(p.y + r + 2, map.rows); ++row) {
    for (int column = limited(p.x - r - 1, map.columns); column < limited(p.x + r + 2, map.columns); ++column) {
      if (std::hypot(gap(p.x, column), gap(p.y, row)) <= r) visit(cell_number(map, column, row));
    }
  }
}

// Calls visit(neighbour, whether it shares a side) for the up to eight cells around one.
template <class Visit>
void each_neighbor(const CellMap& map, std::size_t cell, Visit visit) {
  const auto columns = static_cast<std::size_t>(map.columns);
  const int column = static_cast<int>(cell % columns), row = static_cast<int>(cell / columns);
  for (int dy = row > 0 ? -1 : 0; dy <= 1 && row + dy < map.rows; ++dy) {
    for (int dx = column > 0 ? -1 : 0; dx <= 1 && column + dx < map.columns; ++dx) {
      if (dx != 0 || dy != 0) visit(cell_number(map, column + dx, row + dy), dx == 0 || dy == 0);
    }
  }
}

}  // namespace krait::host
