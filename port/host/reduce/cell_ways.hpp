// SPDX-License-Identifier: Apache-2.0
// Shortest ways over the cells of a map.
#pragma once

#include "host/reduce/cell_distances.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// Dijkstra's algorithm from one of the marked cells to all others, by steps of 1 to cells that share a side and 1.4 to
// those that share a corner, where both cells beside that are marked, too (Dial 1969: buckets by length).
class CellWays {
 public:
  CellWays(const CellMap& map, const CellMask& marked, std::size_t from);

  // From the first cell to this one, straightened; empty where there is none.
  std::vector<std::size_t> way_to(std::size_t cell) const;
  // Of the shortest way to this cell, in metres; infinite where there is none.
  double length_to(std::size_t cell) const;
  // The nearest of these cells by way; the map's number of cells where none can be reached.
  std::size_t nearest(const std::vector<std::size_t>& cells) const;

 private:
  // Whether both cells that share sides with these two, which share a corner, are marked.
  bool passes_corner(std::size_t a, std::size_t b) const;
  bool sees(std::size_t from, std::size_t to) const;

  const CellMap& map_;
  const CellMask& marked_;
  std::size_t from_;
  std::vector<std::uint32_t> lengths_;  // in fifths of a cell
};

// The cells on the straight line between the middles of two, both included: each shares a side or a corner with the
// next.
std::vector<std::size_t> cells_on_line(const CellMap& map, std::size_t from, std::size_t to);

}  // namespace krait::host
