// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/cell_ways.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

#include "host/reduce/cells.hpp"

namespace krait::host {
namespace {

constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t kStraight = 5, kDiagonal = 7;  // fifths of a cell
constexpr std::size_t kBuckets = kDiagonal + 1;

// The quotient, down > 0, rounded to the nearest integer.
std::int64_t rounded_quotient(std::int64_t up, std::int64_t down) {
  const std::int64_t twice = 2 * up + down;
  return (twice >= 0 ? twice : twice - 2 * down + 1) / (2 * down);
}

}  // namespace

std::vector<std::size_t> cells_on_line(const CellMap& map, std::size_t from, std::size_t to) {
  const std::int64_t columns = map.columns;
  const auto first = static_cast<std::int64_t>(from), last = static_cast<std::int64_t>(to);
  const std::int64_t dx = last % columns - first % columns, dy = last / columns - first / columns;
  const std::int64_t steps = std::max(std::abs(dx), std::abs(dy));
  std::vector<std::size_t> line = {from};
  for (std::int64_t i = 1; i <= steps; ++i) {
    const std::int64_t column = first % columns + rounded_quotient(i * dx, steps);
    const std::int64_t row = first / columns + rounded_quotient(i * dy, steps);
    line.push_back(static_cast<std::size_t>(row * columns + column));
  }
  return line;
}

CellWays::CellWays(const CellMap& map, const CellMask& marked, std::size_t from)
    : map_(map), marked_(marked), from_(from), lengths_(marked.size(), kNever) {
  std::array<std::vector<std::size_t>, kBuckets> buckets;
  std::size_t waiting = 1;
  lengths_[from] = 0;
  buckets[0].push_back(from);
  for (std::uint32_t length = 0; waiting > 0; ++length) {
    std::vector<std::size_t> now;
    now.swap(buckets[length % kBuckets]);
    waiting -= now.size();
    for (const std::size_t cell : now) {
      if (lengths_[cell] != length) continue;
      each_neighbor(map, cell, [&](std::size_t other, bool side) {
        const std::uint32_t through = length + (side ? kStraight : kDiagonal);
        if (marked[other] == 0 || lengths_[other] <= through || !(side || passes_corner(cell, other))) return;
        lengths_[other] = through;
        buckets[through % kBuckets].push_back(other);
        ++waiting;
      });
    }
  }
}

double CellWays::length_to(std::size_t cell) const {
  if (lengths_[cell] == kNever) return std::numeric_limits<double>::infinity();
  return double(lengths_[cell]) / kStraight * map_.resolution;
}

std::size_t CellWays::nearest(const std::vector<std::size_t>& cells) const {
  std::size_t best = marked_.size();
  std::uint32_t least = kNever;
  for (const std::size_t cell : cells) {
    if (lengths_[cell] < least) least = lengths_[cell], best = cell;
  }
  return best;
}

bool CellWays::passes_corner(std::size_t a, std::size_t b) const {
  const auto columns = static_cast<std::size_t>(map_.columns);
  return marked_[a / columns * columns + b % columns] != 0 && marked_[b / columns * columns + a % columns] != 0;
}

bool CellWays::sees(std::size_t from, std::size_t to) const {
  const std::vector<std::size_t> line = cells_on_line(map_, from, to);
  return std::all_of(line.begin(), line.end(), [&](std::size_t cell) { return marked_[cell] != 0; });
}

// A point of the way stays where the next one is the first that the last point that stayed does not see.
std::vector<std::size_t> CellWays::way_to(std::size_t cell) const {
  if (lengths_[cell] == kNever) return {};
  std::vector<std::size_t> way = {cell};
  std::size_t before = cell;
  for (std::size_t at = cell; at != from_;) {
    std::size_t next = at;
    each_neighbor(map_, at, [&](std::size_t other, bool side) {
      const std::uint32_t step = side ? kStraight : kDiagonal;
      if (lengths_[other] == kNever || lengths_[other] + step != lengths_[at]) return;
      if (side || passes_corner(at, other)) next = other;
    });
    at = next;
    if (!sees(way.back(), at)) way.push_back(before);
    before = at;
  }
  if (way.back() != from_) way.push_back(from_);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace krait::host
