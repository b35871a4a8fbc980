// SPDX-License-Identifier: Apache-2.0
#include "peers/peer_robot.hpp"

#include "robot/shape.hpp"

namespace krait::bench {
namespace {

// A control of up to `rate` either way that changes a component of the state.
ControlAxis rate_axis(float rate, int component, float least, float most, bool drives) {
  return {-rate, rate, component, least, most, drives};
}

std::vector<ControlAxis> axes_of(const Chain& robot) {
  const ChainParameters& p = robot.parameters();
  return {rate_axis(p.max_acceleration, 3, p.min_speed, p.max_speed, true),
          rate_axis(p.max_steering_rate, 4, -p.max_steering, p.max_steering, false)};
}

std::vector<ControlAxis> axes_of(const KinematicTruck& robot) {
  const KinematicTruckParameters& p = robot.parameters();
  return {{p.min_speed, p.max_speed}, {-p.max_steering, p.max_steering}};
}

std::vector<ControlAxis> axes_of(const Unicycle& robot) {
  const UnicycleParameters& p = robot.parameters();
  return {{p.min_speed, p.max_speed}, {-p.max_turn_rate, p.max_turn_rate}};
}

std::vector<ControlAxis> axes_of(const Unicycle2& robot) {
  const Unicycle2Parameters& p = robot.parameters();
  return {rate_axis(p.max_acceleration, 3, p.min_speed, p.max_speed, true),
          rate_axis(p.max_turn_acceleration, 4, -p.max_turn_rate, p.max_turn_rate, false)};
}

std::vector<ControlAxis> axes_of(const DifferentialDrive& robot) {
  const DifferentialDriveParameters& p = robot.parameters();
  return {rate_axis(p.max_wheel_acceleration, 3, -p.max_wheel_speed, p.max_wheel_speed, true),
          rate_axis(p.max_wheel_acceleration, 4, -p.max_wheel_speed, p.max_wheel_speed, true)};
}

}  // namespace

PeerRobot::PeerRobot(const host::RobotSpec& spec)
    : robot_(spec), axes_(robot_.visit([](const auto& robot) { return axes_of(robot); })) {}

float PeerRobot::width() const { return 2.0F * detail::inner_radius(core().body(0), {}); }

void PeerRobot::steer(const float* state, const Target& target, float* control) const {
  Steering steering;
  robot_.visit([&](const auto& robot) {
    robot.steer(StateView(state, robot.state_size()), target, steering, ControlRef(control, robot.control_size()));
  });
}

void PeerRobot::drive_straight(Vec2 at, float heading, float speed_share, float* state) const {
  (void)core().rest(at, heading, nullptr, 0, state);
  for (const ControlAxis& axis : axes_) {
    if (axis.drives) state[axis.component] = speed_share * axis.most;
  }
}

}  // namespace krait::bench
