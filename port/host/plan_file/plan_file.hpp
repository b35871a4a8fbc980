// SPDX-License-Identifier: Apache-2.0
// A plan as it stands in JSON: what `krait plan` writes and `krait verify`, the pictures and users read.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/input/file.hpp"
#include "host/robot_file/robot_file.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

struct PlanFile {
  std::string status;  // "solved", or why not
  std::string scene;
  std::uint64_t seed = 1;
  std::string planner;
  RobotSpec robot;
  double dt = 0;  // seconds
  std::string goal_name;
  std::optional<GoalFacing> goal_facing;  // absent: the robot may be turned in any way
  Ring goal_polygon;                      // local coordinates; a disc goal's polygon has many vertices inside the disc
  std::vector<std::string> state_names;
  std::vector<std::vector<float>> states;    // local coordinates: world = origin + local
  std::vector<std::vector<float>> controls;  // states.size() - 1 of them
  Point origin;
  std::shared_ptr<const nlohmann::ordered_json> statistics;  // an object; null where there are none
};

// States and controls stand only in a solved plan; every float is the shortest decimal that reads back to its bits.
// Throws std::logic_error where a number is NaN or infinite or the arrays disagree: JSON cannot say it.
nlohmann::ordered_json to_json(const PlanFile& plan);

// Reads and checks the form (types, sizes, finiteness); throws InputError with the field's name.
PlanFile read_plan(const std::string& path);

// The same from the file's text; `file` is what errors name.
PlanFile parse_plan(const std::string& text, const std::string& file);

}  // namespace krait::host
