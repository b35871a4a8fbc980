// SPDX-License-Identifier: Apache-2.0
// Where the middle of a disc may be on a map of cells, and what of the map such discs can touch.
#pragma once

#include <limits>

#include "host/reduce/cell_distances.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// Cells that hold the centre of an open disc of `radius` metres that meets no occupied cell and stays on the map.
// possible: all of them, and such in which only a disc smaller by up to 0.92 cells fits. sure: only such that the disc
// fits around their middle, and none where a disc larger by 0.21 cells does not.
// For a disc around a point c of cell k, and an occupied cell o whose middle is d cells from that of k: the square o
// holds a disc of 1/2 around its middle and lies in one of sqrt(1/2). So o is between d - sqrt(1/2) and d - 1/2 away
// from the middle of k, and c is within sqrt(1/2) of that: the disc fits around c only if radius <= d - 1/2 +
// sqrt(1/2), and around the middle if radius <= d - sqrt(1/2).
enum class Fit { possible, sure };
CellMask disc_centers(const CellMap& map, double radius, Fit fit);

// Cells with a point that is within `reach` metres of a point of a marked cell: all of them and no others.
CellMask within_reach(const CellMap& map, const CellMask& marked, double reach);

// The marked cells that steps from side to side over marked cells lead to from one of the seeds, at most `steps` of
// them (seeds are numbers of cells; those that are not marked are passed over). Any way in marked cells is such steps:
// of a corner that it passes it touches all four cells.
CellMask connected(const CellMap& map, const CellMask& marked, std::vector<std::size_t> seeds,
                   std::size_t steps = std::numeric_limits<std::size_t>::max());

// The cells of the map that are not occupied.
CellMask free_cells(const CellMap& map);

// Leaves of the marked cells those that are not occupied.
void leave_free(const CellMap& map, CellMask& marked);

// The map with those cells occupied, too, that are not kept.
CellMap without(const CellMap& map, const CellMask& kept);

}  // namespace krait::host
