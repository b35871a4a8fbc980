// SPDX-License-Identifier: Apache-2.0
// The check of a robot for programs in C, in an archive of its own: it has a heap, and needs C++'s run-time library.
#include <algorithm>
#include <limits>
#include <memory>

#include "c/model.hpp"
#include "krait/robot_check.hpp"

namespace {

template <class To, class From>
std::vector<To> listed(const From* first, std::size_t count) {
  std::vector<To> list;
  for (std::size_t i = 0; first != nullptr && i < count; ++i) list.push_back(krait::c::convert<To>(first[i]));
  return list;
}

// Without those of states and controls where the robot's sizes cannot be used, which check_robot names.
krait::RobotRanges ranges_of(const krait_ranges& from, const krait::Robot& robot) {
  krait::RobotRanges ranges;
  if (robot.sizes_valid()) {
    ranges.state = listed<krait::RobotRange>(from.state, static_cast<std::size_t>(robot.state_size()));
    ranges.control = listed<krait::RobotRange>(from.control, static_cast<std::size_t>(robot.control_size()));
  }
  if (from.dt_count > 0) ranges.dt = listed<float>(from.dt, from.dt_count);
  ranges.headings = listed<int>(from.headings, from.heading_count);
  ranges.translation_invariant = from.translation_invariant;
  ranges.leaving_share = from.leaving_share;
  ranges.step_rate = from.step_rate;
  ranges.step_error = from.step_error;
  if (from.complete_state != nullptr) {
    ranges.complete_state = [&from](std::vector<float>& state) { from.complete_state(from.self, state.data()); };
  }
  return ranges;
}

// Headings that are counted and do not lie anywhere are a fault of the ranges: without them no direction is checked.
krait::RobotReport checked(const krait::Robot& robot, const krait_ranges& from, int samples, std::uint64_t seed) {
  const bool missing = from.headings == nullptr && from.heading_count > 0;
  if (!missing) return krait::check_robot(robot, ranges_of(from, robot), samples, seed);
  const std::string what = "headings is NULL, where heading_count is " + std::to_string(from.heading_count) + ".";
  return {{{"ranges", "headings", what, std::numeric_limits<double>::infinity(), 0}}, 0};
}

}  // namespace

krait_ranges krait_default_ranges(const krait_range* state, const krait_range* control) {
  const krait::RobotRanges defaults;
  krait_ranges ranges{};
  ranges.state = state;
  ranges.control = control;
  ranges.translation_invariant = defaults.translation_invariant;
  ranges.leaving_share = defaults.leaving_share;
  ranges.step_rate = defaults.step_rate;
  ranges.step_error = defaults.step_error;
  return ranges;
}

uint32_t krait_check_robot(const krait_robot* robot, const krait_ranges* ranges, uint32_t samples, uint64_t seed,
                           char* text, size_t bytes) {
  const bool made = krait::c::is_made(robot);
  const auto place = std::make_unique<std::byte[]>(made ? robot->model->robot_bytes : 0);
  const krait::Robot view = made ? robot->model->make(place.get(), *robot) : krait::Robot();
  const auto most = static_cast<std::uint32_t>(std::numeric_limits<int>::max());
  const krait::RobotReport report = checked(view, *ranges, static_cast<int>(std::min(samples, most)), seed);
  if (bytes > 0) {
    const std::string lines = report.text();
    const std::size_t count = std::min(lines.size(), bytes - 1);
    std::copy_n(lines.begin(), count, text);
    text[count] = '\0';
  }
  return static_cast<uint32_t>(report.faults.size());
}
