// SPDX-License-Identifier: GPL-3.0-or-later
// Starts of a scene where a robot has no room, or none has.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/compiler/compiler.hpp"
#include "host/robot_file/robot_file.hpp"
#include "host/run/run.hpp"

namespace krait::host {

// Why the robot cannot begin at the request's start; none where it can.
std::optional<std::string> why_blocked(const krait::Scene& scene, const SearchRequest& request);

// A line for each start where the robot does not stand free, with the clearance of the library, or cannot stand.
std::vector<std::string> blocked_starts(const CompiledScene& scene, const RobotSpec& robot);

// A line for each start within the bounds whose position lies in an obstacle; `asked`: whether a tolerance was asked
// for, which may be why.
std::vector<std::string> starts_in_obstacles(const CompiledScene& scene, bool asked);

}  // namespace krait::host
