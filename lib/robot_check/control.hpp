// SPDX-License-Identifier: Apache-2.0
// Whether steer keeps to the limits of controls and states, and brakes.
#pragma once

#include "robot_check/case.hpp"

namespace krait::detail::checking {

// Steps of all runs so far, and those of them that left the limits.
struct SteeredSteps {
  int all = 0;
  int leaving = 0;
};

// Steers from the sample's state toward the target until a step leaves the limits, `steps` at most.
void check_steer(const Case& c, const Target& target, int steps, SteeredSteps& counted);

// Brakes from the sample's state, by the target with a speed of 0, until the robot is at rest or a step leaves the
// limits: whether a robot that says how fast it is has become slower after 20 steps.
void check_braking(const Case& c, Target target);

// Whether more of the steps left the limits than the ranges allow.
void check_leaving(Findings& findings, const RobotRanges& ranges, const SteeredSteps& counted);

}  // namespace krait::detail::checking
