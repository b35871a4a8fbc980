// SPDX-License-Identifier: Apache-2.0
// Whether ranges fit a robot, can be drawn from, and let its motion be checked.
#pragma once

#include <map>

#include "robot_check/report.hpp"

namespace krait::detail::checking {

// False, and the first of them that cannot be used is a fault, where a check cannot begin.
bool check_ranges(const Robot& robot, const RobotRanges& ranges, Findings& findings);

// Samples of a time step, and those of them whose motion was checked since a control ends it within the limits.
struct DrivenSamples {
  int all = 0;
  int checked = 0;
};

// How many controls are drawn for a sample until one ends its step within the limits.
inline constexpr int kControlsTried = 20;

// Whether enough motions were checked of every time step.
void check_driven(const std::map<float, DrivenSamples>& by_step, Findings& findings);

}  // namespace krait::detail::checking
