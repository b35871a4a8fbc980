// SPDX-License-Identifier: Apache-2.0
// What controllers ask for, where it can be computed by hand.
#include <gtest/gtest.h>

#include "krait/krait.hpp"

namespace krait::test {
namespace {

TEST(RobotSteering, AUnicycleBacksNoFasterThanItCan) {
  UnicycleParameters p;
  p.min_speed = -0.25F;
  const Unicycle robot(p);
  const float state[] = {0, 0, 0};
  Target behind;
  behind.point = {-5, 0};
  behind.speed = -1;
  Steering steering;
  float control[2];
  robot.steer(StateView(state, 3), behind, steering, ControlRef(control, 2));
  EXPECT_FLOAT_EQ(control[0], -0.25F);
  EXPECT_NEAR(control[1], 0.0F, 1e-5F);
}

// Half left at full speed would need a wheel faster than it can be: the drive goes slower, and turns as it should.
TEST(RobotSteering, ADifferentialDriveSlowsDownToTurn) {
  DifferentialDriveParameters p;
  p.max_wheel_acceleration = 1e5F;
  const DifferentialDrive robot(p);
  const float state[] = {0, 0, 0, 0, 0};
  Target left;
  left.point = {5, 5};
  Steering steering;
  float control[2];
  robot.steer(StateView(state, 5), left, steering, ControlRef(control, 2));
  const float wheels[] = {control[0] * left.dt, control[1] * left.dt};
  const float error = 0.78539816F;
  const float turn_rate = 3.0F * error + 0.05F * error * left.dt;
  EXPECT_NEAR((wheels[1] - wheels[0]) * p.wheel_radius / p.track_width, turn_rate, 1e-3F);
  EXPECT_NEAR(wheels[1], p.max_wheel_speed, 1e-3F);
  EXPECT_GT(wheels[0], 0.0F);
}

}  // namespace
}  // namespace krait::test
