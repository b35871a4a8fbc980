// SPDX-License-Identifier: GPL-3.0-or-later
// Goals of a scene that a robot has no way to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/compiler/compiler.hpp"
#include "host/robot_file/robot_file.hpp"
#include "krait/scene.hpp"

namespace krait::host {

// Why the robot has no way from the first start to that goal, with the clearance of the library; none where it may have
// one, or cannot begin there, or the scene has no start.
std::optional<std::string> why_closed(const krait::Scene& scene, const RobotSpec& robot, Index goal);

// A line for each goal of which it says why, but for those of which no part is free.
std::vector<std::string> closed_goals(const CompiledScene& scene, const RobotSpec& robot);

}  // namespace krait::host
