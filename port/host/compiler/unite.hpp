// SPDX-License-Identifier: GPL-3.0-or-later
// The union of obstacles, on the grid.
#pragma once

#include <vector>

#include "host/compiler/geometry.hpp"

namespace krait::host::compiler {

struct United {
  Edges boundary;  // solid on the left; sound
  int passes = 0;  // no boundary moved inwards by more than 0.71 grid steps a pass
};

// A single part may be any tangle: solid is what has winding[0] != 0 and winding[1] == 0. Several parts must each be
// sound, with winding {1, 0} and the solid on the left. Nothing gets lost: what is thinner than the grid becomes a wall
// one step thick, or two where rounding lets one collapse. All lies within `bounds`; along them no such wall is made.
// Throws InputError where walls go on collapsing, which no drawing is known to cause.
United unite(std::vector<Edges> parts, const GridBox& bounds);

}  // namespace krait::host::compiler
