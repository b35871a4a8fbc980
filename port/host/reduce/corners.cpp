// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/corners.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "host/reduce/cells.hpp"
#include "host/reduce/disc.hpp"

namespace krait::host {
namespace {

// How many corners the outline has in the lower left corner of a cell; those of the row above the map and of the column
// beside it are asked for, too. What is off the map is occupied. Two cells that touch in a corner only make two.
template <class Occupied>
int corners_at(const CellMap& map, int column, int row, Occupied occupied) {
  const auto at = [&](int x, int y) {
    return x < 0 || y < 0 || x >= map.columns || y >= map.rows || occupied(cell_number(map, x, y)) ? 1 : 0;
  };
  const int a = at(column - 1, row - 1), b = at(column, row - 1), c = at(column - 1, row), d = at(column, row);
  if (a + b + c + d != 2) return (a + b + c + d) % 2;
  return a == d ? 2 : 0;
}

// The wanted cells that touch one, itself among them; they are taken out of `wanted`.
std::vector<std::size_t> take_group(const CellMap& map, CellMask& wanted, std::size_t first) {
  std::vector<std::size_t> group = {first};
  wanted[first] = 0;
  for (std::size_t i = 0; i < group.size(); ++i) {
    each_neighbor(map, group[i], [&](std::size_t other, bool) {
      if (wanted[other] == 0) return;
      wanted[other] = 0;
      group.push_back(other);
    });
  }
  return group;
}

// Whether there are fewer corners at those of the cells with `after` than with `before`.
bool simpler(const CellMap& map, const std::vector<std::size_t>& cells, const CellMask& before, const CellMask& after) {
  std::vector<std::pair<int, int>> places;
  const auto columns = static_cast<std::size_t>(map.columns);
  for (const std::size_t cell : cells) {
    const int column = static_cast<int>(cell % columns), row = static_cast<int>(cell / columns);
    for (const int dy : {0, 1}) {
      for (const int dx : {0, 1}) places.emplace_back(column + dx, row + dy);
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  int difference = 0;
  for (const auto& [column, row] : places) {
    difference += corners_at(map, column, row, [&](std::size_t cell) { return after[cell] != 0; });
    difference -= corners_at(map, column, row, [&](std::size_t cell) { return before[cell] != 0; });
  }
  return difference < 0;
}

}  // namespace

CellMap occupied_where_simpler(const CellMap& map, const CellMask& wanted, const CellMask& always) {
  CellMask left = wanted;
  leave_free(map, left);
  CellMap result = map;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i] == 0) continue;
    const std::vector<std::size_t> group = take_group(map, left, i);
    for (const std::size_t cell : group) result.occupied[cell] = 1;
    const bool asked = std::any_of(group.begin(), group.end(), [&](std::size_t cell) { return always[cell] != 0; });
    if (asked || simpler(map, group, map.occupied, result.occupied)) continue;
    for (const std::size_t cell : group) result.occupied[cell] = 0;
  }
  return result;
}

}  // namespace krait::host
