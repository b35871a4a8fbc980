// SPDX-License-Identifier: Apache-2.0
// The cells of a map that a goal covers.
#pragma once

#include <cstddef>
#include <vector>

#include "host/workspace/workspace.hpp"

namespace krait::host {

// Those whose middles lie in the goal, and those that hold one of its corners, in case it is smaller than a cell.
std::vector<std::size_t> cells_of(const CellMap& map, const Goal& goal);

}  // namespace krait::host
