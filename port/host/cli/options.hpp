// SPDX-License-Identifier: Apache-2.0
// Options that several commands share, and how their texts are read.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "host/input/number_option.hpp"
#include "host/run/run.hpp"

namespace krait::host {

// "128K", "64M", "1G" (powers of 1024) or a number of bytes; at most 64G. Throws InputError.
std::uint64_t parse_memory(const std::string& text);

// --start NAME or X,Y,HEADING (metres, radians, world) into the request. Throws InputError.
void parse_start(const std::string& text, SearchRequest& request);

// --goal NAME or X,Y,RADIUS into the request. Throws InputError.
void parse_goal(const std::string& text, SearchRequest& request);

// Lets an option take whole numbers from `least` to `most` only: -1 and numbers that do not fit are refused, not
// wrapped.
CLI::Validator whole_number(std::uint64_t most, const std::string& unit = {}, std::uint64_t least = 0);

// Lets an option take what the library takes for a parameter; an end that is open there is a millionth off.
CLI::Validator number_of(Argument argument, const std::string& unit);
CLI::Validator whole_number_of(Argument argument, const std::string& unit);

// The text with that range: "a time step, seconds, 0.001 to 1".
std::string with_range(const std::string& text, Argument argument);

// The goal of that name, or the first one where the name is empty; null: there is none such.
const Goal* find_goal(const Workspace& map, const std::string& name);

// What --help says of what holds where an option is not given.
struct QueryDefaults {
  const char* start;
  const char* heading;
  const char* end_speed;
};

// The texts of what plan and verify both ask: robot, start and goal.
struct QueryOptions {
  std::string robot = "snake:15";
  std::string start;
  std::string goal;
  std::optional<double> heading;  // radians
  double heading_tolerance = GoalFacing().tolerance;
  bool either_way = false;
  std::optional<double> hitch_tolerance;
  bool any_heading = false;
  std::optional<double> end_speed;

  void add(CLI::App& command, const QueryDefaults& defaults);
  bool robot_is_file() const;  // and not a model's name
  bool robot_given() const;    // and not the default
  bool asks_heading() const;   // or one of its tolerances
  void read(SearchRequest& request) const;

  // After read: the goal of the map that is named, or its first, where that is a pose. Options take the place of what
  // it says of its heading. Throws InputError where they have no heading.
  void read_pose(const Workspace& map, SearchRequest& request) const;

 private:
  const char* lone_tolerance() const;  // the first of the options that need a heading; null: none is given
  GoalFacing facing(const GoalFacing& usual) const;
  CLI::App* command_ = nullptr;
};

}  // namespace krait::host
