// SPDX-License-Identifier: Apache-2.0
// The name that a map has for the obstacle at a place.
#pragma once

#include <string>

#include "host/workspace/workspace.hpp"

namespace krait::host {

// The label of what is nearest to the place, no further from it than `reach` metres; empty: there is nothing. Throws
// InputError for an unusable map.
std::string obstacle_near(const Workspace& workspace, const Point& at, double reach);

}  // namespace krait::host
