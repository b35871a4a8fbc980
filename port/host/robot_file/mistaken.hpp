// SPDX-License-Identifier: Apache-2.0
// Files that people take for a robot's.
#pragma once

#include <optional>
#include <string>

namespace krait::host {

// What the file is instead of a ROBOT.json and what to do, by its content: "is a map, not a robot: give it as the MAP
// of …". Nothing where it may be a ROBOT.json.
std::optional<std::string> mistaken_robot(const std::string& path, const std::string& content);

}  // namespace krait::host
