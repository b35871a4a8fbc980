// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/fill.hpp"

#include <numbers>
#include <utility>

#include "host/reduce/cells.hpp"
#include "host/reduce/corners.hpp"
#include "host/reduce/disc.hpp"

namespace krait::host {

namespace {

std::vector<std::size_t> marked_cells(const CellMask& marked) {
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (marked[i] != 0) cells.push_back(i);
  }
  return cells;
}

}  // namespace

CellMap filled(const CellMap& map, const Girth& girth, const std::vector<Point>& starts) {
  const CellMask all_centers = disc_centers(map, girth.inner, Fit::possible);
  CellMask centers = all_centers;
  if (!starts.empty()) {
    std::vector<std::size_t> seeds;
    for (const Point start : starts) {
      each_around(map, start, girth.spread, [&](std::size_t cell) { seeds.push_back(cell); });
    }
    centers = connected(map, centers, std::move(seeds));
  }
  CellMask near = within_reach(map, centers, girth.outer);
  leave_free(map, near);
  const auto steps = static_cast<std::size_t>(std::numbers::sqrt2 * girth.outer / map.resolution + 2);
  CellMask untouched = connected(map, near, marked_cells(centers), steps);
  for (std::uint8_t& cell : untouched) cell = cell == 0;
  return occupied_where_simpler(map, untouched, all_centers);
}

}  // namespace krait::host
