// SPDX-License-Identifier: GPL-3.0-or-later
// Where free space is narrow: whether a wall somewhere would leave less than a given width across from it.
#pragma once

#include <vector>

#include "host/compiler/cell_index.hpp"
#include "host/compiler/geometry.hpp"

namespace krait::host::compiler {

class Passages {
 public:
  // Rings with free space on the left; width in grid steps.
  Passages(const std::vector<GridRing>& rings, double width);

  // Whether an edge of the rings lies across from the segment from a to b, on its left: less than the width away, and
  // facing it by less than 60 degrees.
  bool narrow(GridPoint a, GridPoint b) const;

 private:
  Edges edges_;
  double width_;
  CellIndex index_;
  CellLists lists_;
};

}  // namespace krait::host::compiler
