// SPDX-License-Identifier: GPL-3.0-or-later
// Distances to the boundary of the free space: widths of portals, the clearance grid.
#pragma once

#include <memory>
#include <vector>

#include "host/compiler/geometry.hpp"

namespace krait::host::compiler {

class Distances {
 public:
  explicit Distances(const Edges& boundary);
  ~Distances();
  Distances(const Distances&) = delete;
  Distances& operator=(const Distances&) = delete;

  // Distance of a point to the nearest edge; grid steps; infinite without edges.
  double to_point(double x, double y) const;
  // Distance of a closed box to the nearest edge; 0 if it meets one.
  double to_box(const GridBox& box) const;
  // At least twice the largest distance of a point of the segment, and at most 1 % and 4 mm more.
  double width(GridPoint a, GridPoint b) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace krait::host::compiler
