// SPDX-License-Identifier: Apache-2.0
// A part of a map.
#pragma once

#include "host/workspace/workspace.hpp"

namespace krait::host {

// The workspace within the box (metres, world): its bounds become those of both, what lies outside is wall. Cells that
// the box cuts stay; the compiler cuts them. Throws InputError where the box holds nothing of the workspace, or where a
// start or all of a goal lies outside.
Workspace cropped(Workspace workspace, Point min, Point max);

}  // namespace krait::host
