// SPDX-License-Identifier: Apache-2.0
#include "robot_check/ranges.hpp"

#include <algorithm>

namespace krait::detail::checking {
namespace {

// The promise that ranges break, and how.
struct Flaw {
  const char* promise = nullptr;  // none: they break none
  std::string sentence = {};
};

Flaw flaw_of_sizes(const Robot& robot, const RobotRanges& ranges) {
  if (ranges.state.size() == static_cast<std::size_t>(robot.state_size()) &&
      ranges.control.size() == static_cast<std::size_t>(robot.control_size()) && !ranges.dt.empty()) {
    return {};
  }
  return {"sizes", "there are " + std::to_string(ranges.state.size()) + " ranges of states, " +
                       std::to_string(ranges.control.size()) + " of controls and " + std::to_string(ranges.dt.size()) +
                       " time steps; the robot has " + std::to_string(robot.state_size()) + " and " +
                       std::to_string(robot.control_size()) + ", and one time step is needed."};
}

// A range whose width is more than a float holds cannot be drawn from.
Flaw flaw_of(const char* promise, const std::vector<RobotRange>& ranges) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const RobotRange& range = ranges[i];
    if (range.low <= range.high && finite(range.high - range.low)) continue;
    return {promise, "the range of component " + std::to_string(i) + " of the " + promise + " is " +
                         list({range.low, range.high}) +
                         "; both ends must be finite, and the first not above the second."};
  }
  return {};
}

Flaw flaw_of_steps(const std::vector<float>& dt) {
  for (const float step : dt) {
    if (step > 0 && finite(step)) continue;
    return {"dt", "a time step is " + number(static_cast<double>(step)) + " s; all must be finite and above 0."};
  }
  return {};
}

Flaw flaw_of_headings(const Robot& robot, const std::vector<int>& headings) {
  for (const int i : headings) {
    const std::string component = "component " + std::to_string(i) + " of the state is named a heading";
    if (i < 2 || i >= robot.state_size()) {
      return {"headings", component + "; those from 2 to " + std::to_string(robot.state_size() - 1) + " may be one."};
    }
    if (std::count(headings.begin(), headings.end(), i) > 1) return {"headings", component + " twice."};
  }
  return {};
}

Flaw flaw_of_number(const char* name, float value, float most, const char* rule) {
  if (value >= 0 && value <= most && finite(value)) return {};
  return {name, std::string(name) + " is " + number(static_cast<double>(value)) + "; it must be " + rule};
}

}  // namespace

bool check_ranges(const Robot& robot, const RobotRanges& ranges, Findings& findings) {
  constexpr const char* kRule = "finite and 0 or more.";
  for (const Flaw& flaw :
       {flaw_of_sizes(robot, ranges), flaw_of("state", ranges.state), flaw_of("control", ranges.control),
        flaw_of_steps(ranges.dt), flaw_of_headings(robot, ranges.headings),
        flaw_of_number("leaving_share", ranges.leaving_share, 1.0F, "from 0 to 1."),
        flaw_of_number("step_rate", ranges.step_rate, kInfinity, kRule),
        flaw_of_number("step_error", ranges.step_error, kInfinity, kRule)}) {
    if (flaw.promise == nullptr) continue;
    findings.add("ranges", flaw.promise, flaw.sentence);
    return false;
  }
  return true;
}

void check_driven(const std::map<float, DrivenSamples>& by_step, Findings& findings) {
  constexpr int kLeastShare = 10;  // one in so many
  for (const auto& [dt, samples] : by_step) {
    if (kLeastShare * samples.checked >= samples.all) continue;
    findings.add("ranges", "motion",
                 "in " + std::to_string(samples.all - samples.checked) + " of " + std::to_string(samples.all) +
                     " samples with a time step of " + number(static_cast<double>(dt)) + " s none of " +
                     std::to_string(kControlsTried) +
                     " controls ends it within the limits, so that travel, quick_bound and whether the robot moves "
                     "alike everywhere were not checked there: shorten the time step, or narrow the ranges of the "
                     "state or the control.");
  }
}

}  // namespace krait::detail::checking
