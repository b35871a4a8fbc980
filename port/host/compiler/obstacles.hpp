// SPDX-License-Identifier: GPL-3.0-or-later
// A workspace's obstacles of every kind, made sound on the grid.
#pragma once

#include <string>
#include <vector>

#include "host/compiler/frame.hpp"

namespace krait::host::compiler {

struct Solid {
  Edges boundary;     // of the union of all obstacles within the bounds, solid on the left; sound
  int roundings = 0;  // each moved no boundary inwards by more than 0.71 grid steps
};

// Throws InputError naming an obstacle whose coordinates are not finite; adds a warning for one that crosses itself,
// has no area, is all hole, or is open where a hole lies along its outline.
Solid solid_of(const Workspace& workspace, const Frame& frame, std::vector<std::string>& warnings);

}  // namespace krait::host::compiler
