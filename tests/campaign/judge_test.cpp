// SPDX-License-Identifier: Apache-2.0
// The campaign's judge finds what it is there to find: contacts of millimetres, between states too, limits, goals
// missed, states that the controls do not lead to.
#include "judge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace krait::campaign {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kPi2 = std::numbers::pi / 2;

host::Ring rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

host::Workspace hall(const std::vector<host::Ring>& obstacles) {
  host::Workspace workspace;
  workspace.max = {20, 10};
  for (const host::Ring& ring : obstacles) workspace.obstacles.push_back({"obstacle", ring, {}});
  return workspace;
}

Robot unicycle() {
  Robot robot;
  robot.model = Model::unicycle;
  robot.unicycle.max_speed = 100;
  robot.unicycle.max_turn_rate = 100;
  return robot;
}

Robot snake(int trailers) {
  Robot robot;
  robot.model = Model::snake;
  robot.chain.trailers = trailers;
  return robot;
}

using Control = std::array<float, 2>;

// The plan that such controls make.
PlanRecord driven(const Robot& robot, const std::vector<double>& start, const std::vector<Control>& controls,
                  float dt) {
  const Equations equations(robot);
  Drive drive(equations);
  PlanRecord plan;
  plan.dt = dt;
  State state{};
  std::copy(start.begin(), start.end(), state.begin());
  const auto add = [&] {
    for (std::size_t i = 0; i < static_cast<std::size_t>(equations.state_size()); ++i) {
      plan.states.push_back(static_cast<float>(state[i]));
    }
  };
  add();
  for (const Control& control : controls) {
    const double u[2] = {static_cast<double>(control[0]), static_cast<double>(control[1])};
    state = drive.hold(state, u, static_cast<double>(dt)).back();
    plan.controls.insert(plan.controls.end(), control.begin(), control.end());
    add();
  }
  return plan;
}

Verdict judged(const Robot& robot, const host::Workspace& workspace, const PlanRecord& plan,
               const Region& goal = Disc{0, 0, 100}) {
  return judge(robot, Field(workspace, {0, 0}), goal, plan);
}

// Along y = 5 from x = 1 to x = 11; the body reaches to y = 5.2.
PlanRecord straight() { return driven(unicycle(), {1, 5, 0}, std::vector<Control>(100, {1, 0}), 0.1F); }

TEST(Judge, LetsAPlanPassThatKeepsTwoMillimetres) {
  const Verdict verdict = judged(unicycle(), hall({rectangle(5, 5.202, 6, 6)}), straight());
  EXPECT_TRUE(verdict.holds());
  EXPECT_NEAR(verdict.clearance, 0.002, 1e-6);
  EXPECT_LT(verdict.position_error, 1e-6);
}

TEST(Judge, FindsTwoMillimetresInAWall) {
  const Verdict verdict = judged(unicycle(), hall({rectangle(5, 5.198, 6, 6)}), straight());
  ASSERT_THAT(verdict.collisions, SizeIs(1));
  EXPECT_THAT(verdict.collisions[0], HasSubstr("body 0 meets an obstacle"));
  EXPECT_NEAR(verdict.clearance, -0.002, 1e-5);
}

TEST(Judge, FindsTwoMillimetresBeyondTheBounds) {
  PlanRecord plan = straight();
  host::Workspace workspace = hall({});
  workspace.max.y = 5.198;
  EXPECT_THAT(judged(unicycle(), workspace, plan).collisions, SizeIs(1));
}

TEST(Judge, FindsAnOccupiedCell) {
  host::Workspace workspace = hall({});
  workspace.cells = host::CellMap{40, 20, 0.5, {0, 0}, 0, std::vector<std::uint8_t>(800, 0)};
  EXPECT_TRUE(judged(unicycle(), workspace, straight()).holds());
  workspace.cells->occupied[10 * 40 + 12] = 1;
  EXPECT_THAT(judged(unicycle(), workspace, straight()).collisions, SizeIs(1));
}

TEST(Judge, FindsAFoilThatAStepJumpsOver) {
  const PlanRecord plan = driven(unicycle(), {1, 5, 0}, {{10, 0}}, 1);
  EXPECT_THAT(judged(unicycle(), hall({rectangle(6, 0, 6.00001, 10)}), plan).collisions, SizeIs(1));
}

TEST(Judge, FindsACornerThatTouchesWithinATurn) {
  Robot robot = unicycle();
  robot.unicycle.body_length = 2;
  const PlanRecord plan = driven(robot, {5, 5, 0}, {{0, 1}}, static_cast<float>(kPi2));
  const double reach = std::hypot(1, 0.2);
  const auto pole = [&](double distance) {
    const double x = 5 + distance * std::cos(0.7), y = 5 + distance * std::sin(0.7);
    return hall({rectangle(x, y, x + 0.01, y + 0.01)});
  };
  EXPECT_TRUE(judged(robot, pole(reach + 0.001), plan).holds());
  EXPECT_THAT(judged(robot, pole(reach - 0.001), plan).collisions, SizeIs(1));
}

TEST(Judge, FindsAStartInsideAnObstacle) {
  PlanRecord plan = driven(unicycle(), {5, 5, 0}, {}, 0.1F);
  EXPECT_THAT(judged(unicycle(), hall({rectangle(2, 2, 8, 8)}), plan).collisions, SizeIs(1));
}

TEST(Judge, FindsAHoleOfAnObstacleFree) {
  host::Workspace workspace = hall({rectangle(2, 2, 8, 8)});
  workspace.obstacles[0].holes = {rectangle(4, 4, 6, 6)};
  EXPECT_TRUE(judged(unicycle(), workspace, driven(unicycle(), {5, 5, 0}, {}, 0.1F)).holds());
}

TEST(Judge, FindsAControlThatIsOnePercentMore) {
  PlanRecord plan = straight();
  plan.controls[100] *= 1.01F;
  EXPECT_THAT(judged(unicycle(), hall({}), plan).others, SizeIs(1));
}

TEST(Judge, FindsStatesThatStepAside) {
  PlanRecord plan = straight();
  for (std::size_t i = 0; i <= 100; ++i) plan.states[3 * i + 1] += 1e-4F * static_cast<float>(i);
  EXPECT_THAT(judged(unicycle(), hall({}), plan).others, SizeIs(1));
}

TEST(Judge, FindsNumbersThatAreNone) {
  PlanRecord plan = straight();
  plan.states[50] = std::nanf("");
  EXPECT_THAT(judged(unicycle(), hall({}), plan).others, SizeIs(1));
  PlanRecord cut = straight();
  cut.states.pop_back();
  EXPECT_THAT(judged(unicycle(), hall({}), cut).others, SizeIs(1));
}

TEST(Judge, FindsAGoalMissedByAMillimetre) {
  EXPECT_THAT(judged(unicycle(), hall({}), straight(), Disc{11, 6, 1.001}).misses, IsEmpty());
  EXPECT_THAT(judged(unicycle(), hall({}), straight(), Disc{11, 6, 0.999}).misses, SizeIs(1));
  EXPECT_THAT(judged(unicycle(), hall({}), straight(), rectangle(10.5, 4, 11.001, 6)).misses, IsEmpty());
  EXPECT_THAT(judged(unicycle(), hall({}), straight(), rectangle(10.5, 4, 10.999, 6)).misses, SizeIs(1));
}

TEST(Judge, FindsSpeedsAndControlsOffLimits) {
  Robot slow = unicycle();
  slow.unicycle.max_speed = 0.999F;
  EXPECT_THAT(judged(slow, hall({}), straight()).off_limits, SizeIs(1));
  const PlanRecord plan = driven(snake(0), {2, 5, 0, 0, 0}, std::vector<Control>(10, {1, 0.5F}), 0.1F);
  Robot robot = snake(0);
  robot.chain.max_speed = 1.001F;
  EXPECT_THAT(judged(robot, hall({}), plan).off_limits, IsEmpty());
  robot.chain.max_speed = 0.999F;
  EXPECT_THAT(judged(robot, hall({}), plan).off_limits, SizeIs(1));
  robot.chain.max_speed = 2;
  robot.chain.max_steering = 0.499F;
  EXPECT_THAT(judged(robot, hall({}), plan).off_limits, SizeIs(1));
  robot.chain.max_steering = 1;
  robot.chain.max_acceleration = 0.999F;
  EXPECT_THAT(judged(robot, hall({}), plan).off_limits, SizeIs(1));
}

// The car steers to the left and back to the right within one step.
TEST(Judge, FindsAHitchThatBendsTooFarBetweenStates) {
  Robot robot = snake(1);
  robot.chain.max_steering = 1.5F;
  const PlanRecord plan = driven(robot, {5, 5, 0, 2, 1.4, 0}, {{0, -2.8F}}, 1);
  const double before = 0, after = std::abs(static_cast<double>(plan.states[8] - plan.states[11]));
  const Equations equations(robot);
  double most = 0;
  for (int i = 0; i <= 1000; ++i) {
    State state{5, 5, 0, 2, 1.4, 0};
    const double u[2] = {0, -2.8};
    for (int part = 0; part < i; ++part) state = advanced(equations, state, u, 0.001);
    most = std::max(most, std::abs(equations.hitch(state, 1)));
  }
  ASSERT_GT(most, 1.05 * std::max(before, after));
  robot.chain.max_hitch_angle = static_cast<float>(most * 1.001);
  EXPECT_THAT(judged(robot, hall({}), plan).off_limits, IsEmpty());
  robot.chain.max_hitch_angle = static_cast<float>(most * 0.999);
  EXPECT_THAT(judged(robot, hall({}), plan).off_limits, SizeIs(1));
}

TEST(Judge, FindsASnakeThatBitesItsTail) {
  Robot robot = snake(12);
  std::vector<double> start{10, 5, 0, 2, 1};
  start.resize(17, 0);
  const PlanRecord plan = driven(robot, start, std::vector<Control>(60, {0, 0}), 0.1F);
  const Verdict verdict = judged(robot, hall({}), plan);
  ASSERT_FALSE(verdict.collisions.empty());
  EXPECT_THAT(verdict.collisions[0], HasSubstr("meets body"));
  robot.chain.self_collision_gap = 13;
  EXPECT_THAT(judged(robot, hall({}), plan).collisions, IsEmpty());
}

}  // namespace
}  // namespace krait::campaign
