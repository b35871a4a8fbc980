// SPDX-License-Identifier: Apache-2.0
#include "host/run/robots.hpp"

#include <algorithm>
#include <iterator>

#include "motion/rk4.hpp"
#include "robot/shape.hpp"

namespace krait::host {
namespace {

double value(const RobotSpec& spec, const char* name) { return spec.parameters.at(name); }
float number(const RobotSpec& spec, const char* name) { return static_cast<float>(value(spec, name)); }

ChainParameters chain_parameters(const RobotSpec& spec) {
  ChainParameters p;
  p.trailers = spec.links;
  p.body_length = number(spec, "body_length");
  p.body_width = number(spec, "body_width");
  p.wheelbase = number(spec, "wheelbase");
  p.hitch_length = number(spec, "hitch_length");
  p.max_speed = number(spec, "max_speed");
  p.min_speed = number(spec, "min_speed");
  p.max_steering = number(spec, "max_steering");
  p.max_acceleration = number(spec, "max_acceleration");
  p.max_steering_rate = number(spec, "max_steering_rate");
  p.self_collision_gap = static_cast<int>(value(spec, "self_collision_gap"));
  p.max_hitch_angle = number(spec, "max_hitch_angle");
  return p;
}

UnicycleParameters unicycle_parameters(const RobotSpec& spec) {
  return {number(spec, "body_length"), number(spec, "body_width"), number(spec, "max_speed"), number(spec, "min_speed"),
          number(spec, "max_turn_rate")};
}

DifferentialDriveParameters differential_drive_parameters(const RobotSpec& spec) {
  return {number(spec, "body_length"), number(spec, "body_width"),      number(spec, "wheel_radius"),
          number(spec, "track_width"), number(spec, "max_wheel_speed"), number(spec, "max_wheel_acceleration")};
}

float farthest_of(Polygon body) { return detail::farthest(body.vertices, body.count); }

float longest_travel_of(const Chain& robot, float dt) {
  const ChainParameters& p = robot.parameters();
  const float way = dt * std::max(p.max_speed, -p.min_speed);
  const float turn = way * std::max(p.max_steering / p.wheelbase, 1.0F / p.hitch_length);
  const float dragged = way * (1.0F + 0.5F * p.max_steering * p.max_steering);
  float farthest = 0.0F;
  for (int k = 0; k < robot.body_count(); ++k) farthest = std::max(farthest, farthest_of(robot.body(k)));
  return dragged + farthest * turn;
}

float longest_travel_of(const Unicycle& robot, float dt) {
  const UnicycleParameters& p = robot.parameters();
  return dt * (std::max(p.max_speed, -p.min_speed) + farthest_of(robot.body(0)) * p.max_turn_rate);
}

float longest_travel_of(const DifferentialDrive& robot, float dt) {
  const DifferentialDriveParameters& p = robot.parameters();
  const float rim = dt * p.wheel_radius * p.max_wheel_speed;
  return rim * (1.0F + 2.0F * farthest_of(robot.body(0)) / p.track_width);
}

TopSpeed of_a_car(const RobotSpec& spec) { return {value(spec, "max_speed"), value(spec, "max_acceleration")}; }
TopSpeed at_once(const RobotSpec& spec) { return {value(spec, "max_speed"), 0}; }
TopSpeed of_wheels(const RobotSpec& spec) {
  const double radius = value(spec, "wheel_radius");
  return {radius * value(spec, "max_wheel_speed"), radius * value(spec, "max_wheel_acceleration")};
}

// The robot of class R, with the parameters and the bodies of the specification.
template <class R, auto parameters>
CoreRobot::Any make(const RobotSpec& spec) {
  R robot(parameters(spec));
  for (std::size_t k = 0; k < spec.bodies.size(); ++k) {
    Vec2 vertices[kMaxVertices];
    int count = 0;
    for (const Point& p : spec.bodies[k]) {
      if (count < kMaxVertices) vertices[count++] = {static_cast<float>(p.x), static_cast<float>(p.y)};
    }
    robot.set_body(static_cast<int>(k), {vertices, count});
  }
  return robot;
}

// What the workstation knows of a model beyond what its class says.
struct Model {
  const char* name;
  CoreRobot::Any (*make)(const RobotSpec& spec);
  TopSpeed (*top_speed)(const RobotSpec& spec);
};

constexpr Model kModels[] = {{"snake", make<Snake, chain_parameters>, of_a_car},
                             {"truck", make<Truck, chain_parameters>, of_a_car},
                             {"car", make<Car, chain_parameters>, of_a_car},
                             {"unicycle", make<Unicycle, unicycle_parameters>, at_once},
                             {"diff_drive", make<DifferentialDrive, differential_drive_parameters>, of_wheels}};

const Model& model_of(const RobotSpec& spec) {
  const Model* const found = std::find_if(std::begin(kModels), std::end(kModels),
                                          [&](const Model& model) { return spec.model == model.name; });
  if (found == std::end(kModels)) throw InputError("robot model \"" + spec.model + "\" is not known");
  return *found;
}

float largest_radius(Polygon body) {
  const Box box = bounding_box(body);
  const Vec2 center = 0.5F * (box.min + box.max);
  float radius = 0.0F;
  for (int i = 0; i < body.count; ++i) radius = std::max(radius, length(body[i] - center));
  return radius * (1.0F + 1e-6F);
}

}  // namespace

CoreRobot::CoreRobot(const RobotSpec& spec) : robot_(model_of(spec).make(spec)) {}

float CoreRobot::longest_travel(float dt) const {
  return visit([dt](const auto& robot) { return longest_travel_of(robot, dt); });
}

RobotExtent extent_of(const CoreRobot& core, const Parameters& parameters) {
  const Robot robot = core.view();
  RobotExtent extent;
  extent.bodies = static_cast<std::uint64_t>(robot.body_count());
  extent.gap = static_cast<std::uint64_t>(robot.self_collision_gap());
  extent.longest_travel = core.longest_travel(parameters.dt);
  extent.length = detail::robot_length(robot);
  extent.tree_parts =
      detail::parts_of(parameters.dt, detail::longest_tree_step(robot, parameters.dt), detail::kMostParts);
  extent.plan_parts =
      detail::parts_of(parameters.dt, detail::longest_plan_step(robot, parameters.dt), detail::kMostPlanParts);
  for (int k = 0; k < robot.body_count(); ++k) {
    extent.largest_radius = std::max(extent.largest_radius, largest_radius(robot.body(k)));
  }
  return extent;
}

RobotExtent extent_of(const RobotSpec& spec, const Parameters& parameters) {
  return extent_of(CoreRobot(spec), parameters);
}

TopSpeed top_speed_of(const RobotSpec& spec) { return model_of(spec).top_speed(spec); }

}  // namespace krait::host
