// SPDX-License-Identifier: Apache-2.0
#include "host/run/tracked_clearance.hpp"

#include <gtest/gtest.h>

namespace krait::host {
namespace {

Ring box(double length, double width) { return {{0, 0}, {length, 0}, {length, width}, {0, width}}; }

TEST(TrackedClearance, IsByTheWidestBodyWhicheverItIs) {
  RobotSpec robot;
  for (std::size_t widest = 0; widest < 3; ++widest) {
    robot.bodies = {box(9, 0.5), box(9, 0.5), box(9, 0.5)};
    robot.bodies[widest] = box(0.1, 2);
    EXPECT_DOUBLE_EQ(tracked_clearance(robot, nullptr), 0.04) << widest;
  }
}

TEST(TrackedClearance, IsHalfACellMoreOnAMapOfCells) {
  RobotSpec robot;
  robot.bodies = {box(1, 0.5)};
  Workspace map;
  EXPECT_DOUBLE_EQ(tracked_clearance(robot, &map), 0.01) << "a drawing";
  map.cells.emplace().resolution = 0.3;
  EXPECT_DOUBLE_EQ(tracked_clearance(robot, &map), 0.16);
}

}  // namespace
}  // namespace krait::host
