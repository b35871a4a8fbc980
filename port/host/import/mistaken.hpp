// SPDX-License-Identifier: Apache-2.0
// Files that people take for maps.
#pragma once

#include <optional>
#include <string>

#include "host/import/format.hpp"

namespace krait::host {

bool is_urdf(const std::string& content);

// One of dynobench's robots, and no problem of it.
bool is_dynobench_robot(const std::string& content);

// What the file is instead of a map and what to do, by its content: "is a robot, not a map: give it to --robot".
// Nothing where it may be a map.
std::optional<std::string> mistaken(const Source& source);

}  // namespace krait::host
