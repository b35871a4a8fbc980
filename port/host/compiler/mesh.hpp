// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of the free space, coarse in the open and fine at passages, conforming to obstacles and goals.
#pragma once

#include <vector>

#include "host/compiler/triangulation.hpp"

namespace krait::host::compiler {

struct FreeTriangle {
  std::uint32_t corners[3];    // counter-clockwise
  std::uint32_t neighbors[3];  // across the edge from corner i to i + 1; kNone at obstacles and bounds
  std::uint32_t goal;          // kNone outside all goals
};

struct Mesh {
  std::vector<GridPoint> vertices;
  std::vector<FreeTriangle> triangles;
};

// `edges` are snapped; winding[0] is not 0 in the free space, winding[1] is a goal's number + 1 in that goal.
// New vertices on a slanting edge may bend it by less than a grid step.
// Coarse: no vertices are added but where an edge would be too long.
Mesh free_mesh(const Edges& edges, const GridBox& bounds, bool coarse = false);

}  // namespace krait::host::compiler
