// SPDX-License-Identifier: Apache-2.0
// From a robot's specification to the core's robot.
#pragma once

#include <variant>

#include "host/robot_file/robot_file.hpp"
#include "host/run/work.hpp"
#include "krait/krait.hpp"

namespace krait::host {

// A robot of the core that a specification describes, of whatever model.
class CoreRobot {
 public:
  using Any = std::variant<Snake, Truck, Car, Unicycle, DifferentialDrive>;

  explicit CoreRobot(const RobotSpec& spec);

  // What `use` returns for the robot as a value of its own class.
  template <class Use>
  auto visit(const Use& use) const {
    return std::visit(use, robot_);
  }
  // Null where it is of another class.
  template <class R>
  const R* as() const {
    return std::get_if<R>(&robot_);
  }
  // Metres: how far a point of a body moves in a time step of dt seconds, at most: at full speed and lock.
  float longest_travel(float dt) const;
  // Refers to this.
  Robot view() const {
    return visit([](const auto& robot) { return Robot(robot); });
  }

 private:
  Any robot_;
};

// What work_bound needs to know of a robot.
RobotExtent extent_of(const CoreRobot& robot, const Parameters& parameters);
RobotExtent extent_of(const RobotSpec& spec, const Parameters& parameters);

// How a robot moves at its top speed.
struct TopSpeed {
  double speed = 0;         // metres a second, forward
  double acceleration = 0;  // metres a second squared, with which it brakes; 0: its speed is its control
};
TopSpeed top_speed_of(const RobotSpec& spec);

}  // namespace krait::host
