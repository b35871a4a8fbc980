// SPDX-License-Identifier: Apache-2.0
// A robot as C++, for firmware: the same bits that the workstation plans with.
#pragma once

#include <string>

#include "host/robot_file/robot_file.hpp"

namespace krait::host {

// A header that defines, in namespace robot_STEM, where STEM is that of the file's path, with `_` for what no name in
// C++ has: the class Robot, kName, kParameters, kBodies, and make(), which returns the robot. `name` is the robot as
// the user names it, and `path` where the header is to lie.
std::string robot_source(const RobotSpec& robot, const std::string& name, const std::string& path);

}  // namespace krait::host
