// SPDX-License-Identifier: Apache-2.0
#include "host/cli/options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "host/cli/commands.hpp"
#include "host/input/bytes.hpp"
#include "host/input/word_option.hpp"
#include "host/run/robot_facts.hpp"
#include "host/workspace/heading.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

// Whether it is a whole turn at most is judged later, where degrees are asked about.
CLI::Validator heading_number() {
  const auto check = [](const std::string& text) -> std::string {
    return parse_number(text) ? "" : "give radians from -2 pi to 2 pi, as 1.57, not " + text;
  };
  return {check, "", "number"};
}

// inf is any speed.
CLI::Validator speed_or_inf() {
  const auto check = [](const std::string& text) -> std::string {
    const std::optional<double> speed = parse_number(text);
    if (text == "inf" || (speed && *speed >= 0)) return "";
    return "give metres a second, 0 or more, or inf, not " + text;
  };
  return {check, "", "number"};
}

// A parameter's range in the library, to a millionth.
std::pair<double, double> range_of(Argument argument) {
  constexpr double kMillion = 1e6;
  const ParameterRange range = Parameters::range(argument);
  return {std::ceil(decimal(range.least) * kMillion) / kMillion, std::floor(decimal(range.most) * kMillion) / kMillion};
}

}  // namespace

std::uint64_t parse_memory(const std::string& text) { return parse_bytes("--memory", text); }

void parse_start(const std::string& text, SearchRequest& request) {
  if (const auto pose = parse_numbers(text, {kMaxCoordinate, kMaxCoordinate, kMaxAngle})) {
    check_heading("--start " + text, (*pose)[2]);
    request.start = StartPose{{(*pose)[0], (*pose)[1]}, (*pose)[2]};
  } else if (text.find(',') != std::string::npos) {
    throw InputError("--start " + text +
                     ": give X,Y,HEADING (metres to 1e7, metres to 1e7, radians to 2 pi) or a start's name" +
                     hint_of_far_place(text));
  } else {
    request.start_name = text;
  }
}

void parse_goal(const std::string& text, SearchRequest& request) {
  if (const auto disc = parse_numbers(text, {kMaxCoordinate, kMaxCoordinate, kMaxCoordinate});
      disc && (*disc)[2] >= kLeastGoalRadius) {
    request.goal = GoalDisc{{(*disc)[0], (*disc)[1]}, (*disc)[2]};
  } else if (text.find(',') != std::string::npos) {
    throw InputError(
        "--goal " + text +
        ": give X,Y,RADIUS (metres to 1e7, the radius 0.001 m or more) or a goal's name; --heading takes a heading" +
        hint_of_far_place(text));
  } else {
    request.goal_name = text;
  }
}

const Goal* find_goal(const Workspace& map, const std::string& name) {
  const auto found = std::find_if(map.goals.begin(), map.goals.end(),
                                  [&](const Goal& goal) { return name.empty() || goal.name == name; });
  return found == map.goals.end() ? nullptr : &*found;
}

CLI::Validator whole_number(std::uint64_t most, const std::string& unit, std::uint64_t least) {
  const auto check = [least, most, unit](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && rest == end && value >= least && value <= most) return {};
    return text + " is no whole number " + (unit.empty() ? "" : "of " + unit + " ") + "from " + std::to_string(least) +
           " to " + std::to_string(most);
  };
  return {check, "", "whole number"};
}

CLI::Validator number_of(Argument argument, const std::string& unit) {
  const auto [least, most] = range_of(argument);
  return number_in(least, most, unit);
}

CLI::Validator whole_number_of(Argument argument, const std::string& unit) {
  const auto [least, most] = range_of(argument);
  return whole_number(static_cast<std::uint64_t>(most), unit, static_cast<std::uint64_t>(least));
}

std::string with_range(const std::string& text, Argument argument) {
  const auto [least, most] = range_of(argument);
  return text + printed(", %.7g to %.7g", least, most);
}

void QueryOptions::add(CLI::App& command, const QueryDefaults& defaults) {
  command_ = &command;
  command
      .add_option("--robot", robot,
                  model_forms(", ", "N trailers, 0 to " + std::to_string(kMaxLinks)) +
                      ", a shipped machine by its name\n(krait robots lists them), or a ROBOT.json")
      ->capture_default_str();
  command
      .add_option(
          "--start", start,
          printed("a start of the scene by NAME, or X,Y,HEADING in metres and radians (default: %s)", defaults.start))
      ->check(not_empty());
  command
      .add_option("--goal", goal, "a goal of the scene by NAME, or a disc X,Y,RADIUS in metres (default: its first)")
      ->check(not_empty());
  command
      .add_option(
          "--heading", heading,
          printed("radians: the heading of the robot's first body at the end, with a goal X,Y,RADIUS or one that "
                  "has\na heading in the map (default: %s)",
                  defaults.heading))
      ->check(heading_number());
  command
      .add_option("--heading-tolerance", heading_tolerance, "radians, 0.0001 to pi: how far off the heading it may end")
      ->check(number_in(kLeastTolerance, std::numbers::pi, "radians"))
      ->capture_default_str();
  command.add_flag("--either-way", either_way, "the opposite heading is accepted as well");
  command
      .add_option("--hitch-tolerance", hitch_tolerance,
                  "radians, 0.0001 to pi: how far a trailer's heading may end off that of the body before it,\n"
                  "with a heading (default: as far as the hitches bend)")
      ->check(number_in(kLeastTolerance, std::numbers::pi, "radians"));
  command.add_flag("--any-heading", any_heading, "the heading of the map's goal is not asked for");
  command
      .add_option(
          "--end-speed", end_speed,
          printed("metres a second, 0 or more: how fast the plan may end, inf for any speed (default: 0, at rest;\n"
                  "%s)",
                  defaults.end_speed))
      ->check(not_empty())
      ->check(speed_or_inf());
}

bool QueryOptions::robot_is_file() const { return is_robot_file(robot); }

bool QueryOptions::robot_given() const { return command_->count("--robot") > 0; }

const char* QueryOptions::lone_tolerance() const {
  for (const char* option : {"--heading-tolerance", "--either-way", "--hitch-tolerance"}) {
    if (command_->count(option) > 0) return option;
  }
  return nullptr;
}

bool QueryOptions::asks_heading() const { return heading || lone_tolerance() != nullptr; }

GoalFacing QueryOptions::facing(const GoalFacing& usual) const {
  GoalFacing facing = usual;
  if (heading) facing.heading = *heading;
  if (command_->count("--heading-tolerance") > 0) facing.tolerance = heading_tolerance;
  if (either_way) facing.either_way = true;
  if (hitch_tolerance) facing.hitches = hitch_tolerance;
  return facing;
}

void QueryOptions::read_pose(const Workspace& map, SearchRequest& request) const {
  const Goal* named = request.goal ? nullptr : find_goal(map, request.goal_name);
  if (named != nullptr && named->pose) {
    request.goal_name = named->name;
    request.goal = GoalDisc{named->pose->position, named->pose->radius};
    if (!any_heading) request.facing = facing(named->pose->facing);
  } else if (heading && !request.goal) {
    throw InputError("--heading: give the goal as --goal X,Y,RADIUS with it, not by the name of a region");
  } else if (heading) {
    request.facing = facing({});
  } else if (const char* option = lone_tolerance()) {
    throw InputError(std::string(option) + ": give --heading RADIANS with it");
  }
}

void QueryOptions::read(SearchRequest& request) const {
  request.robot = parse_robot(robot);
  if (!start.empty()) parse_start(start, request);
  if (!goal.empty()) parse_goal(goal, request);
  if (heading) check_heading("--heading " + shown(*heading), *heading);
  if (any_heading && asks_heading()) {
    throw InputError("--any-heading: excludes --heading, its tolerances and --either-way: drop it or them");
  }
  if (hitch_tolerance && request.robot.links == 0) {
    warn("--hitch-tolerance: the robot has no trailers, of which it could say anything");
  }
  if (!end_speed) return;
  if (const double least = least_speed(request.robot); *end_speed < least) {
    throw InputError(
        printed("--end-speed: the robot is never slower than %.7g m/s: give that or more, or leave it out", least));
  }
  request.parameters.end_speed = static_cast<float>(*end_speed);
}

}  // namespace krait::host
