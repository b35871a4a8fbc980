// SPDX-License-Identifier: GPL-3.0-or-later
// Starts of a scene where a robot has no room.
#pragma once

#include <string>
#include <vector>

#include "host/compiler/compiler.hpp"
#include "host/robot_file/robot_file.hpp"

namespace krait::host {

// A line for each start where the robot does not stand free, with the clearance of the library, or cannot stand.
std::vector<std::string> blocked_starts(const CompiledScene& scene, const RobotSpec& robot);

}  // namespace krait::host
