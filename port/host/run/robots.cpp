// SPDX-License-Identifier: Apache-2.0
#include "host/run/robots.hpp"

namespace krait::host {
namespace {

float number(const RobotSpec& spec, const char* name) { return static_cast<float>(spec.parameters.at(name)); }

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
  p.self_collision_gap = static_cast<int>(spec.parameters.at("self_collision_gap"));
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

// The robot with the specification's bodies.
template <class R>
R with_bodies(R robot, const RobotSpec& spec) {
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

std::variant<Snake, Truck, Car, Unicycle, DifferentialDrive> robot_of(const RobotSpec& spec) {
  if (spec.model == "unicycle") return with_bodies(Unicycle(unicycle_parameters(spec)), spec);
  if (spec.model == "diff_drive") return with_bodies(DifferentialDrive(differential_drive_parameters(spec)), spec);
  if (spec.model == "car") return with_bodies(Car(chain_parameters(spec)), spec);
  if (spec.model == "truck") return with_bodies(Truck(chain_parameters(spec)), spec);
  return with_bodies(Snake(chain_parameters(spec)), spec);
}

}  // namespace

CoreRobot::CoreRobot(const RobotSpec& spec) : robot_(robot_of(spec)) {}

RobotExtent extent_of(const RobotSpec& spec, const Parameters& parameters) {
  return CoreRobot(spec).visit([&](const auto& robot) { return extent(robot, parameters); });
}

}  // namespace krait::host
