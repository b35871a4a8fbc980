// SPDX-License-Identifier: Apache-2.0
// One state and control of a robot, what follows from them, and where faults go.
#pragma once

#include <string>
#include <vector>

#include "robot_check/motion.hpp"

namespace krait::detail::checking {

// What stands in memory before a robot's function writes there: twice another, so that what it leaves shows.
inline constexpr float kFills[] = {12345.0F, -54321.0F};

struct Case {
  const Robot& robot;
  const RobotRanges& ranges;
  Findings& findings;
  Sample sample;             // within the limits
  std::vector<float> other;  // a state within the limits, evaluated in between
  std::vector<float> next;   // where the sample leads
  Motion33 motion;
  std::vector<std::vector<Frame>> frames;  // by time and body

  // `what` is wrong with the sample.
  void fault(const char* function, const char* promise, double by, const std::string& what, const char* remedy) const {
    findings.add(function, promise, by, what, sample, remedy);
  }
};

inline std::string body_number(std::size_t body) { return "body " + std::to_string(body); }

// Whether a state is within the limits in spite of what rounding may make of one of its components.
bool nearly_within_limits(const Robot& robot, const std::vector<float>& state);

// The last in time of a motion's states that lies beyond the limits, or -1.
int beyond_limits(const Robot& robot, const Motion33& motion);

}  // namespace krait::detail::checking
