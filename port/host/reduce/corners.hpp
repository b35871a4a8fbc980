// SPDX-License-Identifier: Apache-2.0
// The corners of the outlines of occupied cells, which a scene's triangles and pieces hang on.
#pragma once

#include "host/reduce/cell_distances.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// The map with those of the wanted cells occupied, too, that lessen the corners of the outlines, or touch a wanted cell
// of `always`: of cells that touch, side by side or corner to corner, all or none.
CellMap occupied_where_simpler(const CellMap& map, const CellMask& wanted, const CellMask& always);

}  // namespace krait::host
