// SPDX-License-Identifier: Apache-2.0
// One state and control of a robot, what follows from them, and where faults go. For hosts.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "krait/robot_check/motion.hpp"

namespace krait::checking {

// What stands in memory before a robot's function writes there: twice another, so that what it leaves shows.
inline constexpr float kFills[] = {12345.0F, -54321.0F};

template <RobotModel R>
struct Case {
  const R& robot;
  const RobotRanges& ranges;
  Findings& findings;
  Sample sample;             // within the limits
  std::vector<float> other;  // a state within the limits, to be asked about in between
  std::vector<float> next;   // where the sample leads
  Motion33 motion;
  std::vector<std::vector<Frame>> frames;  // by time and body

  // `what` is wrong with the sample.
  void fault(const char* function, const char* promise, double by, const std::string& what, const char* remedy) const {
    findings.add(function, promise, by, what, sample, remedy);
  }
};

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

inline std::string body_number(std::size_t body) { return "body " + std::to_string(body); }

// Whether a state is within the limits in spite of what rounding may make of one of its components.
template <RobotModel R>
bool nearly_within_limits(const R& robot, const std::vector<float>& state) {
  if (robot.within_limits(view(state))) return true;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const float little = 1e-5F * (1.0F + std::abs(state[i]));
    for (const float by : {-little, little}) {
      std::vector<float> beside = state;
      beside[i] += by;
      if (robot.within_limits(view(beside))) return true;
    }
  }
  return false;
}

// The last in time of a motion's states that lies beyond the limits, or -1.
template <RobotModel R>
int beyond_limits(const R& robot, const Motion33& motion) {
  for (int i = Motion33::kParts; i >= 0; --i) {
    if (!nearly_within_limits(robot, rounded(motion.states[static_cast<std::size_t>(i)]))) return i;
  }
  return -1;
}

}  // namespace krait::checking
