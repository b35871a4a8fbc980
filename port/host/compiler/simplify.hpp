// SPDX-License-Identifier: GPL-3.0-or-later
// Fewer vertices, obstacles only ever larger: the steps of a map's diagonal walls become straight.
#pragma once

#include <vector>

#include "host/compiler/geometry.hpp"

namespace krait::host::compiler {

// Simplification takes only vertices away, each where no other vertex lies in the triangle that it spans with its
// neighbours: no passage closes, no wall opens, nothing appears or vanishes. A point that becomes solid is at most
// `growth` (and a thousandth of it) from what was solid; what becomes free is at most kShrink from what stays solid.
// Growth 0 takes only vertices in the middle of a straight line. No obstacle grows where that would leave less than
// `narrow` between it and what faces it: a passage that is narrower stays as it is, a wider one stays that wide.
inline constexpr double kShrink = 1;  // grid steps; lets vertices go that rounding has pushed out of a line

// Places around which outlines stay as they are; grid steps.
struct Kept {
  std::vector<GridPoint> places;
  double reach = 0;
};

// Rings as rings_of() returns them, free space on the left; growth and narrow in grid steps.
std::vector<GridRing> simplify(const std::vector<GridRing>& rings, double growth, double narrow = 0,
                               const Kept& kept = {});

}  // namespace krait::host::compiler
