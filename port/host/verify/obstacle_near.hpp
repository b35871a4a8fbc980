// SPDX-License-Identifier: Apache-2.0
// The obstacle that is nearest to a place of a map: its name, and how far it is.
#pragma once

#include <string>
#include <vector>

#include "host/workspace/workspace.hpp"

namespace krait::host {

// The label of what is nearest to the place, no further from it than `reach` metres; empty: there is nothing. Throws
// InputError for an unusable map.
std::string obstacle_near(const Workspace& workspace, const Point& at, double reach);

// Metres from each of the places to the nearest obstacle; `most` where none is nearer. Throws InputError as well.
std::vector<double> rooms_around(const Workspace& workspace, const std::vector<Point>& places, double most);

}  // namespace krait::host
