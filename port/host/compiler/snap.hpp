// SPDX-License-Identifier: GPL-3.0-or-later
// Iterated snap rounding (Hobby 1999; Halperin and Packer 2002): makes any set of edges on the grid meet in
// shared end points only, in exact integers.
#pragma once

#include <vector>

#include "host/compiler/geometry.hpp"

namespace krait::host::compiler {

struct Snapped {
  Edges edges;                // no two cross, touch or overlap but at end points; each once, with its net winding
  std::size_t crossings = 0;  // places where two edges crossed in their interiors
  int passes = 0;             // every pass moved no point of an edge by more than 0.71 grid steps
};

// Edges that pass within half a step of one of the points, or of an end or crossing of others, are led through it.
// Throws InputError if edges cross in more than kMaxCrossings places.
inline constexpr std::size_t kMaxCrossings = 1'000'000;
Snapped snap(Edges edges, const std::vector<GridPoint>& points = {});

}  // namespace krait::host::compiler
