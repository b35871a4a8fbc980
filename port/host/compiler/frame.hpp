// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's local frame: a whole-metre origin in the world, and the grid.
#pragma once

#include "host/compiler/geometry.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host::compiler {

struct Frame {
  Point origin;    // world = origin + local; metres
  GridBox bounds;  // the workspace, rounded inwards

  // World to local coordinates in grid steps, unrounded.
  Point local(Point world) const;
  Point world(GridPoint p) const;
  // The nearest grid point; within the bounds if the point is. The point must be finite and near them.
  GridPoint nearest(Point world) const;
};

// How far a scene may reach from its local origin, for messages.
std::string largest_reach();

// Throws InputError if the bounds are not finite, empty, inverted or too large for the format.
Frame frame_of(const Workspace& workspace);

}  // namespace krait::host::compiler
