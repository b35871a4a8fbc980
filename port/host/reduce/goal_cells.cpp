// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/goal_cells.hpp"

#include <algorithm>

#include "host/reduce/cells.hpp"

namespace krait::host {
namespace {

bool goes_around(const Ring& ring, Point p) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point a = ring[i], b = ring[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

}  // namespace

std::vector<std::size_t> cells_of(const CellMap& map, const Goal& goal) {
  const CellFrame frame(map);
  std::vector<std::size_t> cells;
  Point min{1e18, 1e18}, max{-1e18, -1e18};
  for (const Point world : goal.polygon) {
    const Point p = frame.cells(world);
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    if (const auto cell = cell_at(map, frame, world)) cells.push_back(*cell);
  }
  const auto limited = [](double value, int count) { return static_cast<int>(std::clamp(value, 0.0, double(count))); };
  for (int row = limited(min.y, map.rows); row < limited(max.y + 1, map.rows); ++row) {
    for (int column = limited(min.x, map.columns); column < limited(max.x + 1, map.columns); ++column) {
      const std::size_t cell = cell_number(map, column, row);
      if (goes_around(goal.polygon, middle(map, frame, cell))) cells.push_back(cell);
    }
  }
  return cells;
}

}  // namespace krait::host
