// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/cells.hpp"

#include <string>

namespace krait::host::compiler {
namespace {

constexpr std::size_t kMostEdges = 2'000'000;  // about a gigabyte and a minute

// side(k, along) is +1 where the line k has an occupied cell on its left only, -1 on its right only, at step `along`.
// Calls run(k, first, last, side) for every longest stretch of one side.
template <class Side, class Run>
void runs(int lines, int steps, Side side, Run run) {
  for (int k = 0; k <= lines; ++k) {
    for (int first = 0; first < steps;) {
      const int value = side(k, first);
      int last = first + 1;
      while (last < steps && side(k, last) == value) ++last;
      if (value != 0) run(k, first, last, value);
      first = last;
    }
  }
}

}  // namespace

Edges outline(const CellMap& map, const std::function<GridPoint(int column, int row)>& place) {
  const auto solid = [&map](int column, int row) {
    return column >= 0 && row >= 0 && column < map.columns && row < map.rows && map.at(column, row) ? 1 : 0;
  };
  Edges edges;
  const auto add = [&](GridPoint a, GridPoint b, int value) {
    if (edges.size() == kMostEdges) {
      throw InputError("the map's cells have more than " + std::to_string(kMostEdges) +
                       " edges between free and occupied, as noise has: smooth the map or scale it down");
    }
    edges.push_back(value > 0 ? Edge{a, b, {1, 0}} : Edge{b, a, {1, 0}});
  };
  runs(
      map.rows, map.columns, [&](int row, int column) { return solid(column, row) - solid(column, row - 1); },
      [&](int row, int first, int last, int value) { add(place(first, row), place(last, row), value); });
  runs(
      map.columns, map.rows, [&](int column, int row) { return solid(column - 1, row) - solid(column, row); },
      [&](int column, int first, int last, int value) { add(place(column, first), place(column, last), value); });
  return edges;
}

}  // namespace krait::host::compiler
