// SPDX-License-Identifier: Apache-2.0
// A map's occupied cells as few rectangles.
#pragma once

#include <vector>

#include "host/workspace/workspace.hpp"

namespace krait::host {

// Rectangles that together cover exactly the occupied cells, in the world's frame: runs of a row, joined with equal
// runs of the rows above. The workspace's own obstacles come first; their points and these have the shift added.
std::vector<Obstacle> all_obstacles(const Workspace& workspace);

Point unshifted(const Point& p, const Workspace& workspace);
Ring unshifted(Ring ring, const Workspace& workspace);

}  // namespace krait::host
