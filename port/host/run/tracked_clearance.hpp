// SPDX-License-Identifier: Apache-2.0
// What a robot may be off the plan that it tracks.
#pragma once

#include "host/robot_file/robot_file.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// Metres: 2 % of the width of the robot's widest body and, on a map of cells, half a cell. The map may be null.
double tracked_clearance(const RobotSpec& robot, const Workspace* map);

}  // namespace krait::host
