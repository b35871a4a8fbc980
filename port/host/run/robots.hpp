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
  using Any = AllRobots<std::variant>;

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
  Extremes extremes() const {
    return visit([](const auto& robot) { return robot.extremes(); });
  }
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

}  // namespace krait::host
