// SPDX-License-Identifier: Apache-2.0
// The robots that krait ships: real machines, with the source of each number (ROBOTS.md).
#pragma once

#include <string>
#include <vector>

namespace krait::host {

struct ShippedRobot {
  std::string name;  // as --robot takes it
  std::string text;  // its ROBOT.json, which the build puts into the program
};

// In the order of their list.
const std::vector<ShippedRobot>& shipped_robots();

}  // namespace krait::host
