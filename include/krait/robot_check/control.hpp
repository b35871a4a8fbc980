// SPDX-License-Identifier: Apache-2.0
// Whether steer keeps to the limits of controls and states. For hosts.
#pragma once

#include "krait/robot_check/answers.hpp"

namespace krait::checking {

// Steps of all runs so far, and those of them that left the limits.
struct SteeredSteps {
  int all = 0;
  int leaving = 0;
};

template <RobotModel R>
void check_control(const Case<R>& c, const Sample& at) {
  for (std::size_t i = 0; i < at.control.size(); ++i) {
    const RobotRange range = c.ranges.control[i];
    const float over = at.control[i] > range.high ? at.control[i] - range.high : range.low - at.control[i];
    if (finite(at.control[i]) && over <= 1e-5F * (range.high - range.low)) continue;
    c.findings.add("steer", "control", finite(over) ? static_cast<double>(over) : kInfinite,
                   "component " + std::to_string(i) + " of the control is " +
                       number(static_cast<double>(at.control[i]), 9) + ", not within " +
                       number(static_cast<double>(range.low)) + " and " + number(static_cast<double>(range.high)),
                   at, "Clamp every control; where the target is the position, a direction to it is 0 / 0.");
  }
}

// The same control when asked again, and from known frames.
template <RobotModel R>
void check_steer_repeats(const Case<R>& c, const Sample& at, const Target& target, const Steering& before) {
  Steering steering = before;
  const std::vector<float> again = steer_of(c.robot, at.state, target, steering, kFills[1]);
  if (!same_bits(again, at.control)) {
    c.findings.add("steer", "pure", kInfinite, "asked again it answers " + list(again), at,
                   "It must write every component and depend on nothing but its arguments.");
  }
  const std::vector<Pose> poses = poses_of(c.robot, at.state);
  std::vector<float> by_frames(at.control.size(), kFills[1]);
  steering = before;
  steer(c.robot, view(at.state), poses.data(), target, steering, writable(by_frames));
  if (!same_bits(by_frames, again)) {
    c.findings.add("steer", "frames", kInfinite, "given the frames it answers " + list(by_frames), at,
                   "The control must be the same to the bit with the frames and without.");
  }
}

// Steers from the sample's state toward the target until a step leaves the limits, `steps` at most.
template <RobotModel R>
void check_steer(const Case<R>& c, const Target& target, int steps, SteeredSteps& counted) {
  Steering steering;
  Sample at = c.sample;
  while (steps-- > 0) {
    const Steering before = steering;
    at.control = steer_of(c.robot, at.state, target, steering, kFills[0]);
    check_control(c, at);
    check_steer_repeats(c, at, target, before);
    const std::vector<float> next = rounded(integrated(c.robot, at, static_cast<double>(at.dt), 1).back());
    ++counted.all;
    if (!c.robot.within_limits(view(next))) {
      ++counted.leaving;
      if (c.ranges.leaving > 0) return;
      c.findings.add("steer", "limits", kInfinite, "it leads beyond the limits, to " + list(next), at,
                     "Choose controls whose step of target.dt ends within the limits, inside by more than rounding.");
      return;
    }
    at.state = next;
  }
}

inline void check_leaving(Findings& findings, const RobotRanges& ranges, const SteeredSteps& counted) {
  const double share = counted.all == 0 ? 0 : static_cast<double>(counted.leaving) / counted.all;
  if (ranges.leaving <= 0 || share <= static_cast<double>(ranges.leaving)) return;
  findings.add("steer", "leaving",
               "of " + std::to_string(counted.all) + " steered steps " + number(100 * share) +
                   " % lead beyond the limits, more than the " + number(100 * static_cast<double>(ranges.leaving)) +
                   " % of RobotRanges::leaving. Each ends an expansion of the search.");
}

}  // namespace krait::checking
