// SPDX-License-Identifier: Apache-2.0
// Plans that hold, made by a simulation that shares nothing with the verifier: the train's joints are followed from
// the front to the back as rigid bodies, by the midpoint rule in very small steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/verify/verify.hpp"

namespace krait::host::testing {

using Row = std::vector<double>;

inline Ring rectangle(double min_x, double min_y, double max_x, double max_y) {
  return {{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}};
}

inline bool has_front_axle(const std::string& model) { return model == "snake" || model == "truck" || model == "car"; }

inline RobotSpec robot(const std::string& model, int links = 0) {
  RobotSpec spec;
  spec.model = model;
  spec.links = links;
  if (model == "unicycle") {
    spec.parameters = {{"body_length", 0.7}, {"body_width", 0.5}, {"max_speed", 2.5}, {"max_turn_rate", 2.0}};
  } else if (model == "unicycle2") {
    spec.parameters = {{"body_length", 0.7},   {"body_width", 0.5},       {"max_speed", 2.5},
                       {"max_turn_rate", 2.0}, {"max_acceleration", 5.0}, {"max_turn_acceleration", 5.0}};
  } else if (model == "diff_drive") {
    spec.parameters = {{"body_length", 0.7}, {"body_width", 0.5},       {"wheel_radius", 0.1},
                       {"track_width", 0.4}, {"max_wheel_speed", 20.0}, {"max_wheel_acceleration", 10.0}};
  } else if (model == "kinematic_truck") {
    spec.parameters = {{"body_length", 0.7},  {"body_width", 0.5},         {"wheelbase", 0.8},
                       {"hitch_length", 0.8}, {"max_speed", 2.5},          {"max_steering", 1.0},
                       {"min_speed", 0.0},    {"self_collision_gap", 4.0}, {"max_hitch_angle", 1.5}};
  } else if (has_front_axle(model)) {
    spec.parameters = {{"body_length", 0.7},      {"body_width", 0.5},        {"wheelbase", 0.8},
                       {"hitch_length", 0.8},     {"max_speed", 2.5},         {"max_steering", 1.0},
                       {"max_acceleration", 5.0}, {"max_steering_rate", 4.0}, {"self_collision_gap", 4.0},
                       {"max_hitch_angle", 1.5},  {"min_speed", 0.0}};
  } else {
    throw std::logic_error("no equations of a " + model);
  }
  spec.bodies.assign(static_cast<std::size_t>(links) + 1, rectangle(-0.35, -0.25, 0.35, 0.25));
  return spec;
}

// One of every model; where it may have trailers, one without and one with so many.
inline std::vector<RobotSpec> every_robot(int trailers) {
  std::vector<RobotSpec> robots;
  for (const std::string& model : robot_models()) {
    robots.push_back(robot(model));
    if (most_links(model) > 0) robots.push_back(robot(model, trailers));
  }
  return robots;
}

// Of trailers, whose headings begin with component `first`.
inline void add_trailer_rates(Row& rate, const Row& s, std::size_t first, double pull, double hitch_length) {
  for (std::size_t i = first; i < s.size(); ++i) {
    const double bend = (i == first ? s[2] : s[i - 1]) - s[i];
    rate.push_back(pull * std::sin(bend) / hitch_length);
    pull *= std::cos(bend);
  }
}

// Speed of the point, direction of the heading and turn rate are passed from the axle ahead to the one behind.
inline Row rates(const RobotSpec& spec, const Row& s, const Row& u) {
  const auto parameter = [&](const char* name) { return spec.parameters.at(name); };
  if (spec.model == "unicycle") return {u[0] * std::cos(s[2]), u[0] * std::sin(s[2]), u[1]};
  if (spec.model == "unicycle2") return {s[3] * std::cos(s[2]), s[3] * std::sin(s[2]), s[4], u[0], u[1]};
  if (spec.model == "diff_drive") {
    const double left = s[3] * parameter("wheel_radius");
    const double right = s[4] * parameter("wheel_radius");
    const double forward = (left + right) / 2;
    return {forward * std::cos(s[2]), forward * std::sin(s[2]), (right - left) / parameter("track_width"), u[0], u[1]};
  }
  if (spec.model == "kinematic_truck") {
    Row rate{u[0] * std::cos(s[2]), u[0] * std::sin(s[2]), u[0] * std::tan(u[1]) / parameter("wheelbase")};
    add_trailer_rates(rate, s, 3, u[0], parameter("hitch_length"));
    return rate;
  }
  const double forward = s[3] * std::cos(s[4]);
  Row rate{forward * std::cos(s[2]), forward * std::sin(s[2]), s[3] * std::sin(s[4]) / parameter("wheelbase"), u[0],
           u[1]};
  add_trailer_rates(rate, s, 5, spec.model == "snake" ? s[3] : forward, parameter("hitch_length"));
  return rate;
}

inline Row simulate(const RobotSpec& spec, Row s, const Row& u, double time) {
  const long steps = std::max(5L, std::lround(time / 2e-4));
  const double h = time / static_cast<double>(steps);
  for (long step = 0; step < steps; ++step) {
    const Row first = rates(spec, s, u);
    Row middle = s;
    for (std::size_t i = 0; i < s.size(); ++i) middle[i] += h / 2 * first[i];
    const Row second = rates(spec, middle, u);
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += h * second[i];
  }
  return s;
}

// A robot at rest at a pose in an empty square of 40 m, the goal at the end of its way.
struct Case {
  Workspace workspace;
  PlanFile plan;
  Asked asked;

  Verdict verdict() const { return verify(workspace, plan, asked); }
};

using Steer = std::function<Row(std::size_t step, const Row& state)>;

// Drives `steps` steps of `dt` seconds. The stored states are those of one motion in double precision, rounded.
inline Case drive(const RobotSpec& spec, const Steer& steer, std::size_t steps, Point at = {20, 20},
                  double heading = 0.3, double dt = 0.1) {
  Case c;
  c.workspace.min = {0, 0};
  c.workspace.max = {40, 40};
  c.asked.robot = spec;
  c.asked.start.position = at;
  c.asked.start.heading = heading;
  c.plan.status = "solved";
  c.plan.robot = spec;
  c.plan.dt = dt;

  Row state{at.x, at.y, heading};
  if (spec.model != "unicycle" && spec.model != "kinematic_truck") state.insert(state.end(), {0, 0});
  state.insert(state.end(), static_cast<std::size_t>(spec.links), heading);
  const auto stored = [](const Row& row) { return std::vector<float>(row.begin(), row.end()); };
  const auto read_back = [](const std::vector<float>& row) { return Row(row.begin(), row.end()); };
  c.plan.states.push_back(stored(state));
  state = read_back(c.plan.states.back());
  for (std::size_t step = 0; step < steps; ++step) {
    c.plan.controls.push_back(stored(steer(step, state)));
    state = simulate(spec, state, read_back(c.plan.controls.back()), dt);
    c.plan.states.push_back(stored(state));
  }
  const auto& end = c.plan.states.back();
  const double x = static_cast<double>(end[0]);
  const double y = static_cast<double>(end[1]);
  c.asked.goal = rectangle(x - 1, y - 1, x + 1, y + 1);
  c.plan.goal_polygon = c.asked.goal;
  return c;
}

// Speeds up to 2 m/s, then steers into an arc of 0.4 rad of steering.
inline Row arc_controls(const RobotSpec& spec, std::size_t step, const Row&) {
  const bool starting = step < 10;
  if (spec.model == "unicycle") return {2.0, starting ? 0.0 : 1.0};
  if (spec.model == "unicycle2") return starting ? Row{2, 0} : step < 12 ? Row{0, 5} : Row{0, 0};
  if (spec.model == "kinematic_truck") return {2.0, starting ? 0.0 : 0.4};
  if (spec.model == "diff_drive") return starting ? Row{8, 8} : step < 12 ? Row{-5, 5} : Row{0, 0};
  return starting ? Row{2, 0} : step < 12 ? Row{0, 2} : Row{0, 0};
}

inline Case arc(const std::string& model, int links = 0) {
  const RobotSpec spec = robot(model, links);
  return drive(
      spec, [&](std::size_t step, const Row& state) { return arc_controls(spec, step, state); }, 40);
}

// Straight ahead along the x axis from x = 15, at most 2 m/s, about 7 m of way.
inline Case straight(const RobotSpec& spec) {
  const auto steer = [&](std::size_t step, const Row&) -> Row {
    if (spec.model == "unicycle" || spec.model == "kinematic_truck") return {2, 0};
    if (spec.model == "diff_drive") return step < 20 ? Row{10, 10} : Row{0, 0};
    return step < 10 ? Row{2, 0} : Row{0, 0};
  };
  return drive(spec, steer, 40, {15, 20}, 0);
}

}  // namespace krait::host::testing
