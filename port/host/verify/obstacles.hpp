// SPDX-License-Identifier: Apache-2.0
// Everything that a body must not meet: drawn obstacles, a map's occupied cells, the bounds, the map's own edge.
#pragma once

#include <boost/geometry/index/rtree.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "host/verify/dynamics.hpp"
#include "host/verify/geometry.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// What a body is nearest to.
struct Contact {
  double distance;       // m; 0: overlap or touch
  std::string obstacle;  // its label
  double overlap = 0;    // m, how far the body must move to come free of the piece of it that was found first
};

// Coordinates here are relative to the lower corner of the workspace's bounds, so that a map far from the origin
// loses no precision.
class Obstacles {
 public:
  // Throws InputError if an obstacle, the bounds or the map is unusable. O((n + cells) log n).
  explicit Obstacles(const Workspace& workspace);

  // The nearest obstacle no further than `reach`; distance `reach` and no label if there is none.
  Contact nearest(const Convex& body, double reach) const;

  // The distance to the bounds, and to the edge of the map, from inside; negative by how far it is outside.
  double room(const Convex& body) const;

 private:
  using Pieces = boost::geometry::index::rtree<std::pair<Box, std::uint32_t>, boost::geometry::index::quadratic<16>>;
  using Cells = boost::geometry::index::rtree<Box, boost::geometry::index::quadratic<16>>;

  void add_cells(const CellMap& map, const Point& lower);
  Convex in_map(const Convex& body) const;

  Point size_;  // of the bounds
  std::vector<Convex> pieces_;
  std::vector<std::string> labels_;  // of each piece
  Pieces piece_index_;

  bool has_map_ = false;
  Frame map_;
  Point map_size_;
  double resolution_ = 0;
  Cells cell_index_;  // runs of occupied cells in a row, in the map's frame
};

}  // namespace krait::host
