// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings and maps as nobody would make them, and what to plan in them.
#pragma once

#include <random>

#include "host/run/run.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host::test {

// Of 12 to 200 m a side, near the world's origin or hundreds of kilometres away, with boxes, thin walls, circles,
// polygons that may cross themselves, and now and then a map of cells.
Workspace random_workspace(std::mt19937_64& random);

// A robot of any model with its defaults or with dimensions of its own, a start and a disc to reach, a seed.
SearchRequest random_request(const Workspace& workspace, std::mt19937_64& random);

}  // namespace krait::host::test
