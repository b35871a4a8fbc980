// SPDX-License-Identifier: Apache-2.0
// Closes what a robot cannot touch: gaps between obstacles, pockets, the rooms behind narrow doors.
#pragma once

#include "host/reduce/girth.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// A cell stays free where a point of it is within girth.outer of the centre of a disc of radius girth.inner that lies
// in free space, and free cells lead from there to it, side by side, in no more steps than a straight line of that
// length may take; where there are starts (world positions), of a disc that can be moved from within girth.spread of a
// start to there. Groups of other cells become occupied where the disc could be in them, or where that lessens the
// corners of the outlines (corners.hpp).
//
// Theorem. (1) No cell becomes free. (2) Every placement of a robot of that girth in the free space of `map` (where
// there are starts: every one that it can reach from one of them) lies in the free space of the result.
//
// Proof of (2). A body's disc lies in free space, so that its centre c is in a cell of disc_centers(), which leaves out
// none. Let p be a point of the body. The straight line from c to p lies in the body, so in free cells, all of them
// within girth.outer of c, and passes at most the square root of 2 times its length in cells, and two, from side to
// side. So the cell of p stays free. While the robot moves from a start, c moves through cells that share sides, all of
// them of disc_centers(), from one within girth.spread of the start.
//
// With inner = outer = r and without starts this is the morphological closing of the obstacles by a disc of radius r
// where it makes them simpler, but for cells that the size of a cell leaves open: a gap between long walls closes where
// it is narrower than 2 r less two cells, but for its ends. A robot that is no disc then loses what lies in its corners
// outside of all discs of radius r in its bodies.
CellMap filled(const CellMap& map, const Girth& girth, const std::vector<Point>& starts);

}  // namespace krait::host
