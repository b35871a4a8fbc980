// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene's growth of obstacles takes from its starts and goals.
#pragma once

#include <string>
#include <vector>

#include "host/compiler/compiler.hpp"
#include "host/robot_file/robot_file.hpp"

namespace krait::host {

// Metres a side by which obstacles are grown at most.
double tolerance_of(const CompiledScene& scene);

// A line for each of the scene's starts that the robot cannot begin at (blocked_starts), and for each of its goals that
// it has no way to (closed_goals).
struct Hindered {
  std::vector<std::string> starts, goals;

  std::size_t count() const { return starts.size() + goals.size(); }
};
Hindered hindered(const CompiledScene& scene, const RobotSpec& robot);

// A line for each goal of the workspace whose room, from its middle to the nearest obstacle, the scene's grown
// obstacles have taken a tenth of, or more, where robots are not known. By the default tolerance starts lose none.
std::vector<std::string> narrowed_goals(const Workspace& workspace, const CompiledScene& scene);

}  // namespace krait::host
