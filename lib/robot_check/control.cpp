// SPDX-License-Identifier: Apache-2.0
#include "robot_check/control.hpp"

#include "plan/ending.hpp"
#include "robot_check/answers.hpp"

namespace krait::detail::checking {
namespace {

std::vector<float> steer_of(const Robot& robot, const std::vector<float>& state, const Target& target,
                            Steering& steering, float fill) {
  const std::vector<Pose> poses = poses_of(robot, state);
  std::vector<float> control(static_cast<std::size_t>(robot.control_size()), fill);
  robot.steer(state.data(), poses.data(), target, steering, control.data());
  return control;
}

// Where a step of the sample's ends, as the tree has it.
std::vector<float> end_of(const Case& c, const Sample& at) {
  return rounded(integrated(c.robot, at, static_cast<double>(at.dt), 1).back());
}

void check_control(const Case& c, const Sample& at) {
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

// `memory` went through the same steps as the memory of the steering that chose the sample's control, by calls of its
// own, so that what differs in it shows in a later control.
void check_steer_repeats(const Case& c, const Sample& at, const Target& target, Steering& memory) {
  const std::vector<float> again = steer_of(c.robot, at.state, target, memory, kFills[1]);
  if (same_bits(again, at.control)) return;
  c.findings.add("steer", "pure", kInfinite, "called again it returns " + list(again), at,
                 "It must write every component, and its control and what it leaves in its Steering must depend on "
                 "nothing but its arguments.");
}

}  // namespace

void check_steer(const Case& c, const Target& target, int steps, SteeredSteps& counted) {
  Steering steering, repeated;
  Sample at = c.sample;
  while (steps-- > 0) {
    at.control = steer_of(c.robot, at.state, target, steering, kFills[0]);
    check_control(c, at);
    check_steer_repeats(c, at, target, repeated);
    const std::vector<float> next = end_of(c, at);
    ++counted.all;
    if (!c.robot.within_limits(next.data())) {
      ++counted.leaving;
      if (c.ranges.leaving_share > 0) return;
      c.findings.add("steer", "limits", kInfinite, "it leads beyond the limits, to " + list(next), at,
                     "Choose controls whose step of target.dt ends within the limits, inside by more than rounding.");
      return;
    }
    at.state = next;
  }
}

void check_braking(const Case& c, Target target) {
  constexpr int kSteps = 20;  // so that a robot may answer late
  if (!c.robot.has_speed()) return;
  Steering steering;
  Sample at = c.sample;
  target.speed = 0.0F;
  const float before = c.robot.speed(at.state.data());
  float after = before;
  for (int step = 0; step < kSteps; ++step) {
    if (!(after > kRestSpeed)) return;
    at.control = steer_of(c.robot, at.state, target, steering, kFills[0]);
    check_control(c, at);
    const std::vector<float> next = end_of(c, at);
    if (!c.robot.within_limits(next.data())) return;
    after = c.robot.speed(next.data());
    at.state = next;
  }
  if (after < before) return;
  c.findings.add("steer", "brake", static_cast<double>(after - before),
                 "toward a target whose speed is 0 it goes from " + number(static_cast<double>(before)) + " to " +
                     number(static_cast<double>(after)) + " m/s within " + std::to_string(kSteps) + " steps",
                 c.sample, "It must get slower, down to 0: a plan ends at rest, and there is none without.");
}

void check_leaving(Findings& findings, const RobotRanges& ranges, const SteeredSteps& counted) {
  const double share = counted.all == 0 ? 0 : static_cast<double>(counted.leaving) / counted.all;
  const auto allowed = static_cast<double>(ranges.leaving_share);
  if (allowed <= 0 || share <= allowed) return;
  findings.add("steer", "leaving",
               "of " + std::to_string(counted.all) + " steered steps " + number(100 * share) +
                   " % lead beyond the limits, more than the " + number(100 * allowed) +
                   " % that the ranges allow as `leaving_share`. Each ends an expansion of the search.",
               share - allowed);
}

}  // namespace krait::detail::checking
