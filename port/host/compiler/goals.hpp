// SPDX-License-Identifier: GPL-3.0-or-later
// Goal polygons on the grid.
#pragma once

#include <vector>

#include "host/compiler/frame.hpp"

namespace krait::host::compiler {

struct PlacedGoal {
  GridRing polygon;  // as asked for: counter-clockwise and simple
  GridRing clipped;  // the part within the bounds; may run along them twice
};

// Throws InputError, naming the goal, for one that is not a simple polygon with an area, lies wholly outside the
// bounds, overlaps another or has another's name.
std::vector<PlacedGoal> place_goals(const Workspace& workspace, const Frame& frame);

}  // namespace krait::host::compiler
