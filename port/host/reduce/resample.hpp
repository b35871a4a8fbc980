// SPDX-License-Identifier: Apache-2.0
// A map in cells of another size, or a drawing in cells.
#pragma once

#include "host/workspace/workspace.hpp"

namespace krait::host {

// The map in cells of `size` metres, from the same corner: a cell is occupied where any part of it was, and what is
// left at the right and above where they do not fit is off the map, a wall. So nothing occupied becomes free, and what
// becomes occupied is within `size` times the square root of 2 of what was occupied or off the map. Throws InputError
// for cells finer than the map's own, and for ones that are larger than the map.
CellMap resampled(const CellMap& map, double size);

// A drawing's obstacles as cells of `size` metres from the corner of its bounds: a cell is occupied where an obstacle
// meets it, borders included; what is left at the right and above is a wall, as above. Throws InputError for more than
// kMostCells of them, and for coordinates that are not finite.
inline constexpr double kMostCells = 64e6;
CellMap drawn_in_cells(const Workspace& drawing, double size);

}  // namespace krait::host
