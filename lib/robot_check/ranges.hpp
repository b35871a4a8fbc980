// SPDX-License-Identifier: Apache-2.0
// Whether ranges fit a robot and can be drawn from.
#pragma once

#include "robot_check/report.hpp"

namespace krait::detail::checking {

// False, and the first of them that cannot be used is a fault, where a check cannot begin.
bool check_ranges(const Robot& robot, const RobotRanges& ranges, Findings& findings);

}  // namespace krait::detail::checking
