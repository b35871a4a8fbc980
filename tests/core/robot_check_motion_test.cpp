// SPDX-License-Identifier: Apache-2.0
// The measures by which check_robot judges a motion.
#include <gtest/gtest.h>

#include "checked_robots.hpp"
#include "robot_check/case.hpp"
#include "robot_check/motion.hpp"
#include "robot_check/ranges.hpp"

namespace krait::test::robot_check_motion_test {
namespace {

using namespace detail::checking;

detail::checking::Frame turned_by(double angle) { return {0, 0, std::sin(angle), std::cos(angle)}; }

TEST(RobotCheckMotion, TurnsToEitherSideAreAsLarge) {
  EXPECT_NEAR(angle_between(turned_by(0.5), turned_by(2)), 1.5, 1e-12);
  EXPECT_NEAR(angle_between(turned_by(2), turned_by(0.5)), 1.5, 1e-12);
  EXPECT_NEAR(angle_between(turned_by(3), turned_by(-3)), 0.28319, 1e-5);
}

TEST(RobotCheckMotion, ALineEndsWhereItsEndsAre) {
  EXPECT_NEAR(distance_to_line({1, 2}, {0, 0}, {4, 0}), 2, 1e-12);
  EXPECT_NEAR(distance_to_line({7, 4}, {0, 0}, {4, 0}), 5, 1e-12);
  EXPECT_NEAR(distance_to_line({-3, 4}, {0, 0}, {4, 0}), 5, 1e-12);
  EXPECT_NEAR(distance_to_line({3, 4}, {0, 0}, {0, 0}), 5, 1e-12);
}

TEST(RobotCheckMotion, RoundingGrowsWithEitherCoordinate) {
  EXPECT_DOUBLE_EQ(rounding_at({0, 0}), 3e-6);
  EXPECT_DOUBLE_EQ(rounding_at({-999, 0}), 3e-3);
  EXPECT_DOUBLE_EQ(rounding_at({0, -999}), 3e-3);
}

// Control (acceleration, turn rate): half a circle to the left at 1.5 m/s.
TEST(RobotCheckMotion, EndsWhereTheDerivativeLeads) {
  const Cart cart;
  const Robot robot(cart);
  const Sample sample{{0, 0, 0, 1.5F}, {0, 2}, 1.5707964F};
  const Motion33 motion = fine_motion(robot, sample, static_cast<double>(sample.dt));
  EXPECT_TRUE(motion.resolved);
  ASSERT_EQ(motion.states.size(), 33U);
  EXPECT_NEAR(motion.end()[0], 0, 1e-5);
  EXPECT_NEAR(motion.end()[1], 1.5, 1e-5);
  EXPECT_NEAR(motion.states[16][0], 0.75, 1e-5);
  EXPECT_NEAR(motion.states[16][1], 0.75, 1e-5);
}

TEST(RobotCheckLimits, RoundingOnEitherSideOfThemIsForgiven) {
  const Cart cart;
  const Robot robot(cart);
  for (const float speed : {-1e-6F, 0.0F, 1.500001F})
    EXPECT_TRUE(nearly_within_limits(robot, {0, 0, 0, speed})) << speed;
  for (const float speed : {-1e-3F, 1.501F}) EXPECT_FALSE(nearly_within_limits(robot, {0, 0, 0, speed})) << speed;
}

TEST(RobotCheckLimits, TheLastStateBeyondThemCounts) {
  const Cart cart;
  const Robot robot(cart);
  Motion33 motion;
  motion.states.assign(33, {0, 0, 0, 1});
  EXPECT_EQ(beyond_limits(robot, motion), -1);
  motion.states[7][3] = 2;
  motion.states[21][3] = -1;
  EXPECT_EQ(beyond_limits(robot, motion), 21);
  motion.states[32][3] = 2;
  EXPECT_EQ(beyond_limits(robot, motion), 32);
}

TEST(RobotCheckMotion, ATenthOfTheSamplesOfEachTimeStepIsEnough) {
  const auto text = [](const DrivenSamples& samples) {
    RobotReport report;
    Findings findings(report);
    check_driven({{0.05F, {100, 100}}, {0.1F, samples}, {0.2F, {100, 100}}}, findings);
    return report.text();
  };
  EXPECT_EQ(text({100, 10}), "");
  EXPECT_EQ(text({0, 0}), "");
  EXPECT_EQ(text({100, 9}).rfind("ranges (motion): in 91 of 100 samples with a time step of 0.1 s none of 20 ", 0), 0U);
}

}  // namespace
}  // namespace krait::test::robot_check_motion_test
