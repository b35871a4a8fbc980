// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of the occupied cells of a map.
#pragma once

#include <functional>

#include "host/compiler/geometry.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host::compiler {

// The boundary between occupied cells and the rest, occupied on the left, one edge for every straight run.
// place(column, row) returns the grid point of a cell's corner.
Edges outline(const CellMap& map, const std::function<GridPoint(int column, int row)>& place);

}  // namespace krait::host::compiler
