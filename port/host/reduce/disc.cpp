// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/disc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/reduce/cells.hpp"

namespace krait::host {
namespace {

// The marked cells and their eight neighbours each.
CellMask widened(const CellMap& map, const CellMask& marked) {
  CellMask wide(marked.size(), 0);
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (marked[i] == 0) continue;
    wide[i] = 1;
    each_neighbor(map, i, [&](std::size_t other, bool) { wide[other] = 1; });
  }
  return wide;
}

}  // namespace

CellMask disc_centers(const CellMap& map, double radius, Fit fit) {
  constexpr double kHalf = 0.5, kDiagonal = 0.5 * std::numbers::sqrt2, kRounding = 1e-9;
  const double least = radius / map.resolution + (fit == Fit::sure ? kDiagonal : kHalf - kDiagonal);
  const double squared = least > 0 ? least * least * (fit == Fit::sure ? 1 + kRounding : 1 - kRounding) : 0;
  const std::vector<std::uint32_t> distances = squared_distances(map.occupied, map.columns, Beyond::marked);
  CellMask centers(distances.size());
  std::transform(distances.begin(), distances.end(), centers.begin(),
                 [&](std::uint32_t d) { return std::uint8_t(d > 0 && double(d) >= squared); });
  return centers;
}

// Squares are as far from each other as the centre of one is from that of the nearest neighbour of the other.
CellMask within_reach(const CellMap& map, const CellMask& marked, double reach) {
  const double most = reach / map.resolution;
  CellMask near = widened(map, marked);
  const std::vector<std::uint32_t> distances = squared_distances(near, map.columns, Beyond::unmarked);
  std::transform(distances.begin(), distances.end(), near.begin(),
                 [&](std::uint32_t d) { return std::uint8_t(double(d) <= most * most * (1 + 1e-9)); });
  return near;
}

CellMask connected(const CellMap& map, const CellMask& marked, std::vector<std::size_t> seeds, std::size_t steps) {
  CellMask found(marked.size(), 0);
  std::vector<std::size_t> next = std::move(seeds), now;
  const auto reach = [&](std::size_t i) {
    if (marked[i] == 0 || found[i] != 0) return;
    found[i] = 1;
    next.push_back(i);
  };
  now.swap(next);
  std::for_each(now.begin(), now.end(), reach);
  for (; steps > 0 && !next.empty(); --steps) {
    now.swap(next);
    next.clear();
    for (const std::size_t i : now) {
      each_neighbor(map, i, [&](std::size_t other, bool side) {
        if (side) reach(other);
      });
    }
  }
  return found;
}

CellMask free_cells(const CellMap& map) {
  CellMask free(map.occupied.size(), 1);
  leave_free(map, free);
  return free;
}

void leave_free(const CellMap& map, CellMask& marked) {
  for (std::size_t i = 0; i < marked.size(); ++i) marked[i] &= map.occupied[i] == 0;
}

CellMap without(const CellMap& map, const CellMask& kept) {
  CellMap result = map;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] == 0) result.occupied[i] = 1;
  }
  return result;
}

}  // namespace krait::host
