// SPDX-License-Identifier: Apache-2.0
#include "host/plan_file/plan_file.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/input/facing.hpp"
#include "host/input/json.hpp"

namespace krait::host {
namespace {

constexpr const char* kFormat = "krait-plan";
constexpr int kVersion = 1;
constexpr const char* kSolved = "solved";
constexpr std::uint64_t kMaxFileBytes = 256U << 20;

// The double whose shortest decimal is the shortest decimal of the float.
double shortest(float value) {
  char text[32];
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
  double result = value;
  std::from_chars(text, end, result);
  return static_cast<float>(result) == value ? result : static_cast<double>(value);
}

Json rows(const std::vector<std::vector<float>>& table) {
  Json list = Json::array();
  for (const std::vector<float>& row : table) {
    Json numbers = Json::array();
    for (const float value : row) numbers.push_back(shortest(value));
    list.push_back(std::move(numbers));
  }
  return list;
}

void require_finite(const Json& value, const std::string& place) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) {
    throw std::logic_error("plan: " + place + " is not finite");
  }
  if (!value.is_structured()) return;
  for (const auto& item : value.items()) require_finite(item.value(), place + "." + item.key());
}

std::vector<std::vector<float>> read_rows(const Field& field, std::size_t width) {
  constexpr double kMost = std::numeric_limits<float>::max();
  std::vector<std::vector<float>> table(field.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Field row = field.item(i);
    if (row.size() != width) row.fail("must have " + std::to_string(width) + " numbers");
    for (std::size_t k = 0; k < width; ++k) {
      table[i].push_back(static_cast<float>(row.item(k).number(-kMost, kMost)));
    }
  }
  return table;
}

void read_header(const Field& field) {
  if (!field.has("format") || field.at("format").value() != kFormat) {
    field.fail("is not a plan: \"format\" must be \"" + std::string(kFormat) + "\"");
  }
  field.at("version").integer(kVersion, kVersion);
}

std::uint64_t read_seed(const Field& field) {
  if (!field.value().is_number_unsigned()) field.fail("must be a whole number from 0 to 2^64 - 1");
  return field.value().get<std::uint64_t>();
}

GoalFacing read_planned_facing(const Field& goal) {
  constexpr double kMostHeading = 1e4;
  constexpr double kMostTolerance = 3.15;
  GoalFacing facing;
  facing.heading = goal.at("heading").number(-kMostHeading, kMostHeading, "radians");
  facing.tolerance = goal.at("heading_tolerance").number(0, kMostTolerance, "radians");
  facing.either_way = goal.at("either_way").boolean();
  if (goal.has("hitch_tolerance")) facing.hitches = goal.at("hitch_tolerance").number(0, kMostHeading, "radians");
  return facing;
}

std::vector<std::string> read_names(const Field& field) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < field.size(); ++i) names.push_back(field.item(i).text());
  return names;
}

void read_motion(const Field& field, PlanFile& plan) {
  const Field names = field.at("state_names");
  plan.state_names = read_names(names);
  if (plan.state_names != state_names(plan.robot)) names.fail("are not those of the robot's model");
  const std::vector<std::string> controls = control_names(plan.robot);
  if (field.has("control_names") && read_names(field.at("control_names")) != controls)
    field.at("control_names").fail("are not those of the robot's model");
  plan.states = read_rows(field.at("states"), plan.state_names.size());
  plan.controls = read_rows(field.at("controls"), controls.size());
  if (plan.status != kSolved) {
    if (!plan.states.empty() || !plan.controls.empty()) field.fail("states and controls stand only in a solved plan");
  } else if (plan.states.size() != plan.controls.size() + 1) {
    field.at("states").fail("must be one more than the controls: " + std::to_string(plan.states.size()) + " states, " +
                            std::to_string(plan.controls.size()) + " controls");
  }
}

}  // namespace

Json to_json(const PlanFile& plan) {
  const bool solved = plan.status == kSolved;
  if (solved && plan.states.size() != plan.controls.size() + 1) {
    throw std::logic_error("plan: states must be one more than controls");
  }
  Json json;
  json["format"] = kFormat;
  json["version"] = kVersion;
  json["status"] = plan.status;
  json["scene"] = plan.scene;
  json["seed"] = plan.seed;
  json["planner"] = plan.planner;
  json["robot"] = to_json(plan.robot);
  json["dt"] = plan.dt;
  json["goal"] = {{"name", plan.goal_name}, {"polygon", to_json(plan.goal_polygon)}};
  if (plan.goal_facing) add_facing(*plan.goal_facing, json["goal"]);
  json["state_names"] = plan.state_names;
  json["control_names"] = control_names(plan.robot);
  json["states"] = solved ? rows(plan.states) : Json::array();
  json["controls"] = solved ? rows(plan.controls) : Json::array();
  json["origin"] = {plan.origin.x, plan.origin.y};
  json["statistics"] = plan.statistics ? *plan.statistics : Json::object();
  require_finite(json, "plan");
  return json;
}

PlanFile read_plan(const std::string& path) { return parse_plan(read_file(path, kMaxFileBytes), path); }

PlanFile parse_plan(const std::string& text, const std::string& file) {
  const Json document = parse_json(text, file);
  const Field field(document, file);
  read_header(field);
  PlanFile plan;
  plan.status = field.at("status").printed();
  plan.scene = field.at("scene").printed();
  plan.seed = read_seed(field.at("seed"));
  plan.planner = field.at("planner").printed();
  plan.robot = read_robot(field.at("robot"));
  plan.dt = field.at("dt").number(1e-6, 1e3, "seconds");
  const Field goal = field.at("goal");
  plan.goal_name = goal.at("name").printed();
  const Field polygon = goal.at("polygon");
  if (plan.status == kSolved || polygon.size() > 0) plan.goal_polygon = polygon.ring();
  if (goal.has("heading")) plan.goal_facing = read_planned_facing(goal);
  read_motion(field, plan);
  plan.origin = field.at("origin").point();
  plan.statistics = std::make_shared<const Json>(field.at("statistics").value());
  if (!plan.statistics->is_object()) field.at("statistics").fail("must be an object");
  return plan;
}

}  // namespace krait::host
