// SPDX-License-Identifier: Apache-2.0
// What check_robot draws: states, controls and targets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot_check/samples.hpp"

namespace krait::test::robot_check_draws_test {
namespace {

constexpr int kDraws = 2000;
constexpr Vec2 kPosition{300, -200};

RobotRanges ranges_of_two() {
  RobotRanges ranges;
  ranges.state = {{-4, 6}, {1, 2}, {-0.5F, 3}};
  ranges.control = {{-7, 0}, {2, 5}};
  ranges.dt = {0.1F, 0.05F};
  return ranges;
}

// How often a number is at the low end of its range, at the high end, and in between.
struct Ends {
  int low = 0;
  int high = 0;
  int between = 0;

  void add(float x, const RobotRange& range) {
    EXPECT_GE(x, range.low);
    EXPECT_LE(x, range.high);
    ++(x == range.low ? low : x == range.high ? high : between);
  }
};

TEST(RobotCheckDraws, NumbersAreNowAndThenAtTheirEnds) {
  const RobotRanges ranges = ranges_of_two();
  detail::checking::Draws draws(ranges, 1);
  Ends x, component, control;
  for (int i = 0; i < kDraws; ++i) {
    const std::vector<float> state = draws.state();
    x.add(state.at(0), ranges.state[0]);
    component.add(state.at(2), ranges.state[2]);
    control.add(draws.control().at(1), ranges.control[1]);
  }
  EXPECT_GT(x.between, kDraws - 10) << "a position is drawn evenly";
  for (const Ends& ends : {component, control}) {
    EXPECT_GT(ends.low, kDraws / 16);
    EXPECT_GT(ends.high, kDraws / 16);
    EXPECT_GT(ends.between, kDraws / 2);
  }
}

TEST(RobotCheckDraws, StatesAreCompletedAndEveryTimeStepIsTried) {
  RobotRanges ranges = ranges_of_two();
  ranges.complete_state = [](std::vector<float>& state) { state[2] = state[0]; };
  detail::checking::Draws draws(ranges, 1);
  std::vector<float> steps;
  for (int i = 0; i < 20; ++i) {
    const std::vector<float> state = draws.state();
    EXPECT_EQ(state.at(2), state.at(0));
    steps.push_back(draws.dt());
  }
  for (const float dt : ranges.dt) EXPECT_NE(std::find(steps.begin(), steps.end(), dt), steps.end()) << dt;
}

TEST(RobotCheckDraws, TargetsLieAroundThePosition) {
  const RobotRanges ranges = ranges_of_two();
  detail::checking::Draws draws(ranges, 1);
  int there = 0, sharpest = 0;
  Vec2 low = kPosition, high = kPosition;
  for (int i = 0; i < kDraws; ++i) {
    const Target target = draws.target(kPosition, false, 0.1F);
    there += target.point.x == kPosition.x && target.point.y == kPosition.y ? 1 : 0;
    sharpest += target.turn == 1.0F ? 1 : 0;
    low = {std::min(low.x, target.point.x), std::min(low.y, target.point.y)};
    high = {std::max(high.x, target.point.x), std::max(high.y, target.point.y)};
    EXPECT_EQ(target.dt, 0.1F);
    EXPECT_GE(target.turn, 0.15F);
    EXPECT_LE(target.turn, 1.0F);
  }
  EXPECT_GT(there, kDraws / 32);
  EXPECT_LT(there, kDraws / 8);
  EXPECT_GT(sharpest, kDraws / 4);
  EXPECT_LT(sharpest, kDraws);
  const Vec2 below = low - kPosition, above = high - kPosition;
  for (const float side : {-below.x, -below.y, above.x, above.y}) {
    EXPECT_GT(side, 19);
    EXPECT_LE(side, 20.001F);
  }
}

TEST(RobotCheckDraws, OnlyWhatCanReverseIsSentBackwards) {
  const RobotRanges ranges = ranges_of_two();
  detail::checking::Draws draws(ranges, 1);
  int backwards = 0;
  for (int i = 0; i < kDraws; ++i) {
    const float forwards = draws.target(kPosition, false, 0.1F).speed;
    EXPECT_GE(forwards, 0.05F);
    EXPECT_LE(forwards, 1.0F);
    const float either = draws.target(kPosition, true, 0.1F).speed;
    EXPECT_GE(std::abs(either), 0.05F);
    EXPECT_LE(std::abs(either), 1.0F);
    backwards += either < 0 ? 1 : 0;
  }
  EXPECT_NEAR(backwards, kDraws / 2, kDraws / 10);
}

}  // namespace
}  // namespace krait::test::robot_check_draws_test
