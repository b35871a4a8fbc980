// SPDX-License-Identifier: Apache-2.0
// What the bound of work knows of a robot, against geometry by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "host/run/robots.hpp"

namespace krait::host {
namespace {

Ring box(double length, double width, double middle) {
  const double x = length / 2, y = width / 2;
  return {{middle - x, -y}, {middle + x, -y}, {middle + x, y}, {middle - x, y}};
}

RobotExtent extent(const RobotSpec& robot, float dt) {
  Parameters parameters;
  parameters.dt = dt;
  return extent_of(robot, parameters);
}

TEST(RobotExtent, ACornerMovesByTheSpeedAndByTurning) {
  RobotSpec robot = parse_robot("unicycle");
  robot.parameters.at("max_speed") = 1.5;
  robot.parameters.at("max_turn_rate") = 2;
  robot.bodies = {box(0.8, 0.6, 0)};
  EXPECT_NEAR(extent(robot, 0.2F).longest_travel, 0.2 * (1.5 + 0.5 * 2), 1e-5);
  EXPECT_NEAR(extent(robot, 0.1F).longest_travel, 0.1 * (1.5 + 0.5 * 2), 1e-5);
}

TEST(RobotExtent, IsThatOfTheLargestBodyWhicheverItIs) {
  RobotSpec robot = parse_robot("truck:2");
  for (std::size_t largest = 0; largest < 3; ++largest) {
    robot.bodies = {box(0.4, 0.3, 0), box(0.4, 0.3, 0), box(0.4, 0.3, 0)};
    robot.bodies[largest] = box(0.8, 0.6, 0.1);  // off its axle, which its circle is not
    const RobotExtent found = extent(robot, 0.1F);
    EXPECT_NEAR(found.largest_radius, 0.5, 1e-5) << largest;
    EXPECT_NEAR(found.length, largest == 0 ? 0.8 : 0.4, 1e-6);
    EXPECT_EQ(found.bodies, 3U);
    EXPECT_EQ(found.gap, 2U);
  }
}

}  // namespace
}  // namespace krait::host
