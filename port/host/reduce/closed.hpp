// SPDX-License-Identifier: Apache-2.0
// Passages of a map that are closed in a version of it with larger cells.
#pragma once

#include "host/workspace/workspace.hpp"

namespace krait::host {

struct ClosedPassage {
  Point place;       // in the world: the narrowest place of the widest way through it
  double width = 0;  // metres, there: twice the distance to the nearest occupied cell, within a cell
};

// Where two parts of the free space of `after` are joined in `before` only, the widest passage first, one for each part
// but one. Parts that vanish altogether are not named. Cells join side by side.
std::vector<ClosedPassage> closed_passages(const CellMap& before, const CellMap& after);

// Names the three widest in a line each, and counts the others.
void warn_of_closed(const std::vector<ClosedPassage>& passages, const std::string& option,
                    std::vector<std::string>& warnings);

}  // namespace krait::host
