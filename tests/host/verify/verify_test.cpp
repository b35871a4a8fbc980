// SPDX-License-Identifier: Apache-2.0
// Sound plans hold, and every way of breaking one is caught.
#include "host/verify/verify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "host/verify/bodies.hpp"
#include "host/verify/dynamics.hpp"
#include "host/verify/geometry.hpp"
#include "host/verify/limits.hpp"
#include "plans.hpp"

namespace krait::host::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

void expect_holds(const Verdict& verdict) {
  EXPECT_TRUE(verdict.holds);
  for (const std::string& line : verdict.complaints) ADD_FAILURE() << line;
}

void expect_complaint(const Case& c, const std::string& part) {
  const Verdict verdict = c.verdict();
  EXPECT_FALSE(verdict.holds);
  EXPECT_THAT(verdict.complaints, Contains(HasSubstr(part)));
}

void add_obstacle(Case& c, Ring outer, std::vector<Ring> holes = {}) {
  const std::string label = "obstacles[" + std::to_string(c.workspace.obstacles.size()) + "]";
  c.workspace.obstacles.push_back({label, std::move(outer), std::move(holes)});
}

void set_goal(Case& c, const Ring& goal) {
  c.asked.goal = goal;
  c.plan.goal_polygon = goal;
}

Point end_of(const Case& c) {
  return {static_cast<double>(c.plan.states.back()[0]), static_cast<double>(c.plan.states.back()[1])};
}

// An empty map that covers the bounds.
CellMap cells(double resolution) {
  CellMap map;
  map.resolution = resolution;
  map.columns = static_cast<int>(std::lround(40 / resolution));
  map.rows = map.columns;
  map.occupied.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows), 0);
  return map;
}

void occupy(CellMap& map, int column, int row) {
  map.occupied[static_cast<std::size_t>(row * map.columns + column)] = 1;
}

class EveryModel : public ::testing::TestWithParam<RobotSpec> {
 protected:
  Case arc_case() const { return arc(GetParam().model, GetParam().links); }
};

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, ::testing::ValuesIn(every_robot(3)),
                         [](const auto& chosen) { return chosen.param.model + std::to_string(chosen.param.links); });

TEST_P(EveryModel, ASoundPlanHolds) {
  const Verdict verdict = arc_case().verdict();
  expect_holds(verdict);
  EXPECT_LT(verdict.step_error, 1e-5);
  EXPECT_LT(verdict.drift, 1e-5);
  EXPECT_NEAR(verdict.goal_depth, 1.0, 1e-5);
  EXPECT_LE(verdict.sweep_error, 2e-5);
  EXPECT_EQ(verdict.clearance, kLargestClearance);
}

TEST_P(EveryModel, EachComponentOfAStateIsHeldToTheDrivenOne) {
  const Case sound = arc_case();
  const std::vector<std::string> names = Dynamics(sound.asked.robot).state_names();
  for (std::size_t component = 0; component < names.size(); ++component) {
    Case c = sound;
    c.plan.states[20][component] += 6e-3F;
    const Verdict verdict = c.verdict();
    EXPECT_FALSE(verdict.holds) << component;
    EXPECT_THAT(verdict.complaints, ElementsAre(StartsWith("state 20: " + names[component] + " differs by 0.006")));
    EXPECT_NEAR(verdict.step_error, 6e-3, 2e-5);
    EXPECT_NEAR(verdict.drift, 6e-3, 2e-5);
  }
}

TEST_P(EveryModel, EachComponentOfAStateIsHeldToTheDrivenOneInEveryStep) {
  const Case sound = arc_case();
  const std::vector<std::string> names = Dynamics(sound.asked.robot).state_names();
  for (std::size_t component = 0; component < names.size(); ++component) {
    Case c = sound;
    c.plan.states[20][component] += 1.2e-3F;
    const Verdict verdict = c.verdict();
    EXPECT_FALSE(verdict.holds) << component;
    EXPECT_THAT(verdict.complaints, ElementsAre(StartsWith("state 20: " + names[component] + " strays by 0.001")));
  }
}

TEST_P(EveryModel, AStateNudgedByLessThanTheToleranceHolds) {
  Case c = arc_case();
  c.plan.states.back()[0] += 9e-4F;
  expect_holds(c.verdict());
  EXPECT_NEAR(c.verdict().step_error, 9e-4, 2e-5);
}

TEST_P(EveryModel, AWrongDtIsCaught) {
  Case c = arc_case();
  c.plan.dt = 0.104;
  expect_complaint(c, "from where the controls lead");
  c.asked.dt = 0.1;
  expect_complaint(c, "dt: is 0.104 s, asked 0.1 s");
}

TEST_P(EveryModel, ADtOfFloatIsAsAsked) {
  Case c = arc_case();
  c.plan.dt = static_cast<double>(0.1F);
  c.asked.dt = 0.1;
  expect_holds(c.verdict());
}

TEST_P(EveryModel, AStartInAnotherPlaceIsCaught) {
  Case c = arc_case();
  c.asked.start.position.x += 1.2e-3;
  expect_complaint(c, "start: state 0 lies 0.0012 m");
}

TEST_P(EveryModel, AnotherHeadingIsCaught) {
  Case c = arc_case();
  c.asked.start.heading += 1e-3;
  expect_complaint(c, "start: theta");
}

TEST_P(EveryModel, EveryParameterMustBeAsAsked) {
  const Case sound = arc_case();
  for (const auto& [name, value] : sound.plan.robot.parameters) {
    Case c = sound;
    c.plan.robot.parameters[name] = value == 0 ? 1e-3 : value * (1 + 1e-5);
    expect_complaint(c, "robot: " + name + " is ");
  }
}

TEST_P(EveryModel, AParameterRoundedToFloatIsAsAsked) {
  Case c = arc_case();
  for (auto& [name, value] : c.plan.robot.parameters) value = static_cast<double>(static_cast<float>(value));
  expect_holds(c.verdict());
}

TEST_P(EveryModel, NeitherDynamicsNorLimitsComeFromThePlansRobot) {
  Case c = arc_case();
  for (auto& [name, value] : c.asked.robot.parameters) value /= name.starts_with("max_") ? 5 : 1;
  c.plan.robot = c.asked.robot;  // what the plan says agrees, what it does not
  expect_complaint(c, "beyond its limit");
}

TEST_P(EveryModel, TheVerdictDoesNotDependOnThePlansOrigin) {
  Case c = arc_case();
  const Point shift{512, -256};
  c.workspace.min = {shift.x, shift.y};
  c.workspace.max = {shift.x + 40, shift.y + 40};
  c.asked.start.position = {shift.x + 20, shift.y + 20};
  for (Point& p : c.asked.goal) p = {p.x + shift.x, p.y + shift.y};
  c.plan.origin = shift;
  const Verdict verdict = c.verdict();
  expect_holds(verdict);
  EXPECT_NEAR(verdict.goal_depth, 1.0, 1e-3);
}

TEST_P(EveryModel, AShiftedOriginIsCaught) {
  Case c = arc_case();
  c.plan.origin = {0.01, 0};
  const Verdict verdict = c.verdict();
  EXPECT_THAT(verdict.complaints, Contains(HasSubstr("start: state 0")));
  EXPECT_THAT(verdict.complaints, Contains(HasSubstr("goal: the plan's polygon differs by 0.01 m")));
}

TEST_P(EveryModel, NotANumberIsCaught) {
  const Case sound = arc_case();
  Case c = sound;
  c.plan.states[7][1] = std::numeric_limits<float>::quiet_NaN();
  expect_complaint(c, "state 7 has a number that is not finite");
  c = sound;
  c.plan.controls[7][1] = std::numeric_limits<float>::infinity();
  expect_complaint(c, "control 7 has a number that is not finite");
}

TEST_P(EveryModel, AMissingControlIsCaught) {
  Case c = arc_case();
  c.plan.controls.pop_back();
  expect_complaint(c, "41 do not go with 39 controls");
}

TEST_P(EveryModel, AnExtraStateIsCaught) {
  Case c = arc_case();
  c.plan.states.push_back(c.plan.states.back());
  expect_complaint(c, "42 do not go with 40 controls");
}

TEST_P(EveryModel, ARowOfAnotherSizeIsCaught) {
  const Case sound = arc_case();
  Case c = sound;
  c.plan.states[3].push_back(0);
  expect_complaint(c, "state 3 has ");
  c = sound;
  c.plan.controls[3].pop_back();
  expect_complaint(c, "control 3 has 1 numbers instead of 2");
}

TEST_P(EveryModel, AControlChangedAfterwardsIsCaughtByTheStateThatItLeadsTo) {
  Case c = arc_case();
  for (float& value : c.plan.controls[25]) value -= 0.5F;
  expect_complaint(c, "state 26: ");
}

// --- form ---

TEST(Form, AnEmptyPlanIsNotSolved) {
  Case c = arc("car");
  c.plan.states.clear();
  c.plan.controls.clear();
  expect_complaint(c, "states: there are none");
  EXPECT_TRUE(std::isnan(c.verdict().clearance));
}

TEST(Form, AStatusOtherThanSolvedDoesNotHold) {
  Case c = arc("car");
  c.plan.status = "budget_used";
  expect_complaint(c, "\"budget_used\"");
}

TEST(Form, SolvedMustBeTrue) {
  Case c = arc("car");
  c.plan.states.resize(20);
  c.plan.controls.resize(19);
  expect_complaint(c, "goal: the driven end lies ");
}

TEST(Form, AUselessDtIsCaught) {
  for (const double dt : {0.0, -0.1, 0.9999e-3, 1.001, 1e30, 1e300, std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::infinity()}) {
    Case c = arc("car");
    c.plan.dt = dt;
    expect_complaint(c, "s, must be from 0.001 to 1 s");
    EXPECT_TRUE(std::isnan(c.verdict().clearance));
  }
}

TEST(Form, AMotionTooFastToBeFollowedEndsInTime) {
  for (const float control : {1e6F, 1e30F}) {
    Case c = arc("snake", 15);
    c.plan.controls[7] = {control, control};
    expect_complaint(c, "step 7: moves too far to be followed");
    EXPECT_TRUE(std::isnan(c.verdict().goal_depth));
  }
}

TEST(Form, AnAbsurdPlanIsRefusedInTime) {
  // Turns on the spot, 16 turns a second, for an hour.
  RobotSpec spec = robot("unicycle");
  spec.parameters["max_turn_rate"] = 120;
  Case c = drive(
      spec, [](std::size_t, const Row&) { return Row{}; }, 0);
  c.plan.dt = 1;
  c.plan.states.resize(3601, c.plan.states[0]);
  c.plan.controls.resize(3600, {0, 100});
  const Verdict verdict = c.verdict();
  EXPECT_THAT(verdict.complaints, Contains(HasSubstr("from here on the refused plan is not looked at")));
  EXPECT_THAT(verdict.complaints, Contains(HasSubstr("state 1: theta differs by 100 from where the controls lead")));
  EXPECT_TRUE(std::isnan(verdict.goal_depth));
}

TEST(Form, StatesFarFromTheOriginAreTooCoarse) {
  Case c = arc("car");
  c.plan.states[5][0] = 1e6F;
  expect_complaint(c, "too coarse");
}

TEST(Form, AStartInsideTheGoalIsAPlanWithoutControls) {
  Case c = arc("snake", 15);
  c.plan.states.resize(1);
  c.plan.controls.clear();
  set_goal(c, rectangle(19, 19, 21, 21));
  expect_holds(c.verdict());
  add_obstacle(c, rectangle(20.1, 20, 20.2, 20.3));
  expect_complaint(c, "start: body 0 overlaps obstacles[0]");
}

TEST(Form, ManyComplaintsAreCutShort) {
  Case c = arc("snake", 25);
  add_obstacle(c, rectangle(-20, -20, 60, 60));
  const Verdict verdict = c.verdict();
  ASSERT_EQ(verdict.complaints.size(), 21U);
  EXPECT_EQ(verdict.complaints.back(), "and 6 more");
}

// --- robot ---

TEST(Robot, AnotherModelIsCaught) {
  Case c = arc("snake", 2);
  c.asked.robot.model = "truck";
  expect_complaint(c, "robot: model is \"snake\", asked \"truck\"");
}

TEST(Robot, ASnakesMotionIsNotATrucks) {
  Case c = arc("snake", 2);
  c.asked.robot.model = c.plan.robot.model = "truck";
  expect_complaint(c, "theta1 strays by ");
}

TEST(Robot, OtherLinksAreCaught) {
  Case c = arc("snake", 3);
  c.asked.robot = robot("snake", 2);
  expect_complaint(c, "robot: has 3 links, asked 2");
}

TEST(Robot, AnotherBodyIsCaught) {
  Case c = arc("snake", 3);
  c.plan.robot.bodies[2][1].x -= 2e-6;
  expect_complaint(c, "robot: body 2 differs by 2e-06 m");
}

TEST(Robot, ABodyWithAnotherNumberOfCornersIsCaught) {
  Case c = arc("snake", 3);
  c.plan.robot.bodies[2].pop_back();
  expect_complaint(c, "robot: body 2 has 3 corners, asked 4");
}

TEST(Robot, TheAskedBodyIsTheOneThatCollides) {
  Case c = straight(robot("car"));
  add_obstacle(c, rectangle(18, 20.3, 19, 21));
  expect_holds(c.verdict());
  c.asked.robot.bodies[0] = rectangle(-0.35, -0.25, 0.35, 0.31);
  const Verdict verdict = c.verdict();
  EXPECT_THAT(verdict.complaints, Contains(HasSubstr("overlaps obstacles[0] by up to 0.01 m")));
}

TEST(Robot, AMissingParameterOfThePlanIsCaught) {
  Case c = arc("car");
  c.plan.robot.parameters.erase("max_speed");
  expect_complaint(c, "robot: parameter max_speed is missing");
}

TEST(Robot, ALeastSpeedOfZeroMayBeSpelledOutOrNot) {
  Case c = arc("car");
  c.asked.robot.parameters.erase("min_speed");
  expect_holds(c.verdict());
  c.plan.robot.parameters["min_speed"] = -1;
  expect_complaint(c, "robot: parameter min_speed was not asked for");
  c = arc("car");
  c.plan.robot.parameters.erase("min_speed");
  expect_holds(c.verdict());
}

TEST(Robot, AnUnusableAskedRobotIsAnInputError) {
  Case c = arc("car");
  c.asked.robot.parameters.erase("wheelbase");
  EXPECT_THROW(c.verdict(), InputError);
  c = arc("car");
  c.asked.robot.parameters["wheelbase"] = 0;
  EXPECT_THROW(c.verdict(), InputError);
  c = arc("car");
  c.asked.robot.model = "boat";
  EXPECT_THROW(c.verdict(), InputError);
}

// --- start ---

TEST(StartState, ItsTrailersMustLieAsAsked) {
  Case c = arc("snake", 3);
  c.asked.start.angles = {0.3, 0.3, 0.31};
  expect_complaint(c, "start: theta3 of state 0");
}

TEST(StartState, AHeadingGivenAFullTurnOffIsTheSame) {
  Case c = arc("snake", 3);
  c.asked.start.heading += 2 * std::numbers::pi;
  expect_holds(c.verdict());
}

TEST(StartState, ItMustBeAtRest) {
  const Case sound = arc("car");
  Case c = sound;
  c.plan.states[0][3] = 1e-3F;
  expect_complaint(c, "start: v of state 0");
  c = sound;
  c.plan.states[0][4] = 1e-3F;
  expect_complaint(c, "start: psi of state 0");
  c = arc("diff_drive");
  c.plan.states[0][3] = 1e-3F;
  expect_complaint(c, "start: left wheel speed of state 0");
}

// --- goal ---

TEST(GoalArea, AnEndAMillimetreOutsideIsCaught) {
  Case c = straight(robot("car"));
  const Point end = end_of(c);
  set_goal(c, rectangle(end.x + 1e-3, 19, end.x + 2, 21));
  expect_complaint(c, "goal: the driven end lies 0.001 m outside");
  EXPECT_NEAR(c.verdict().goal_depth, -1e-3, 1e-4);
}

TEST(GoalArea, AnEndAMillimetreInsideHolds) {
  Case c = straight(robot("car"));
  const Point end = end_of(c);
  set_goal(c, rectangle(end.x - 1e-3, 19, end.x + 2, 21));
  expect_holds(c.verdict());
  EXPECT_NEAR(c.verdict().goal_depth, 1e-3, 1e-4);
}

TEST(GoalArea, TheLastStateMustLieInsideToo) {
  Case c = straight(robot("car"));
  const Point end = end_of(c);
  set_goal(c, rectangle(end.x - 1, 19, end.x + 1e-4, 21));
  expect_holds(c.verdict());
  c.plan.states.back()[0] += 5e-4F;
  expect_complaint(c, "goal: the last state lies 0.000");
}

TEST(GoalArea, AGoalOtherThanAskedIsCaught) {
  Case c = arc("car");
  for (Point& p : c.plan.goal_polygon) p.x += 2e-3;
  expect_complaint(c, "goal: the plan's polygon differs by 0.002 m");
}

// As of a plan for a disc that is judged by the polygon that a compiled scene has in its place.
TEST(GoalArea, OfAGoalThatIsADiscTheOptionIsNamed) {
  Case c = arc("car");
  c.plan.origin = {100, 0};
  c.plan.goal_polygon.clear();
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * std::numbers::pi * i / 64;
    c.plan.goal_polygon.push_back({-82 + 0.1 * std::cos(angle), 8 + 0.1 * std::sin(angle)});
  }
  expect_complaint(c, " m from the one asked for (it is a disc: --goal 18,8,0.1 asks for that)");
  c.plan.goal_polygon[5].x += 0.001;
  for (const std::string& complaint : c.verdict().complaints)
    EXPECT_THAT(complaint, ::testing::Not(HasSubstr("is a disc")));
}

TEST(GoalArea, AGoalWithASpikeIsNotTheOneAskedFor) {
  Case c = arc("car");
  Ring& goal = c.plan.goal_polygon;
  const Point foot{goal[0].x + 0.5, goal[0].y};
  goal.insert(goal.begin() + 1, {foot, {foot.x, foot.y - 0.4}, foot});
  expect_complaint(c, "goal: the plan's polygon differs by 0.4 m");
}

TEST(GoalArea, TheGoalIsWhatWasAskedNotWhatThePlanSays) {
  Case c = arc("car");
  c.asked.goal = rectangle(1, 1, 2, 2);
  expect_complaint(c, "goal: the driven end lies ");
}

TEST(GoalArea, AGoalSnappedToAQuarterMillimetreIsTheSame) {
  Case c = arc("car");
  for (Point& p : c.plan.goal_polygon) p = {std::round(p.x * 4096) / 4096, std::round(p.y * 4096) / 4096};
  expect_holds(c.verdict());
}

Case disc_case(double center_offset) {
  Case c = straight(robot("car"));
  const Point end = end_of(c);
  c.asked.goal.clear();
  c.asked.disc_center = Point{end.x + center_offset, end.y};
  c.asked.disc_radius = 0.5;
  c.plan.goal_polygon.clear();
  for (int i = 0; i < 16; ++i) {
    const double angle = i * std::numbers::pi / 8;
    c.plan.goal_polygon.push_back(
        {c.asked.disc_center->x + 0.5 * std::cos(angle), c.asked.disc_center->y + 0.5 * std::sin(angle)});
  }
  return c;
}

TEST(GoalDisc, AnEndInsideHolds) {
  const Verdict verdict = disc_case(0.3).verdict();
  expect_holds(verdict);
  EXPECT_NEAR(verdict.goal_depth, 0.2, 1e-4);
}

TEST(GoalDisc, AnEndAMillimetreOutsideIsCaught) {
  expect_complaint(disc_case(0.501), "goal: the driven end lies 0.001 m outside");
}

TEST(GoalDisc, APolygonOutOfTheDiscIsCaught) {
  Case c = disc_case(0.1);
  c.plan.goal_polygon[3].x += 0.1;
  expect_complaint(c, "out of the disc");
}

TEST(GoalDisc, APolygonThatMissesTheCenterIsCaught) {
  Case c = disc_case(0.1);
  for (Point& p : c.plan.goal_polygon) p.x = c.asked.disc_center->x + (p.x - c.asked.disc_center->x) / 10 + 0.2;
  expect_complaint(c, "misses the center");
}

// Drives an arc well inside the limits, then lowers one limit so that it is passed by `excess`, relative.
Case beyond(const std::string& model, const std::string& parameter, double reached, double excess, int links = 0) {
  Case c = arc(model, links);
  c.asked.robot.parameters[parameter] = reached / (1 + excess);
  c.plan.robot = c.asked.robot;
  return c;
}

// --- stored states ---

TEST(StoredStates, DriftThatEachStepHidesIsCaught) {
  Case c = straight(robot("car"));
  for (std::size_t i = 1; i < c.plan.states.size(); ++i) c.plan.states[i][1] += static_cast<float>(i) * 8e-4F;
  const Verdict verdict = c.verdict();
  EXPECT_NEAR(verdict.step_error, 8e-4, 1e-5);
  EXPECT_NEAR(verdict.drift, 0.032, 1e-5);
  EXPECT_THAT(verdict.complaints, ElementsAre(StartsWith("state 7: y differs by 0.0056")));
}

TEST(StoredStates, WhatTheyMayStrayByShrinksWithTheTimeStep) {
  for (const double dt : {0.001, 0.01, 0.1, 1.0}) {
    Case c = drive(
        robot("car"),
        [](std::size_t, const Row&) {
          return Row{0, 0};
        },
        5, {20, 20}, 0, dt);
    const auto nudged = [&](double part) {
      Case other = c;
      other.plan.states[3][2] += static_cast<float>(part * std::min(1e-2 * dt, 5e-3));
      return other.verdict();
    };
    expect_holds(nudged(0.98));
    EXPECT_FALSE(nudged(1.02).holds) << dt;
  }
}

TEST(StoredStates, FloatRoundingFarFromTheOriginIsNoStray) {
  Case c = drive(
      robot("unicycle"),
      [](std::size_t, const Row&) {
        return Row{1, 0};
      },
      50, {2020.3, 2020.7}, 0.3, 0.001);
  c.workspace.min = {2000, 2000};
  c.workspace.max = {2040, 2040};
  const Verdict verdict = c.verdict();
  expect_holds(verdict);
  EXPECT_GT(verdict.step_error, 5e-5);
}

TEST(StoredStates, MustKeepLimitsToo) {
  Case c = beyond("car", "max_speed", 2.0, 0);
  expect_holds(c.verdict());
  c.plan.states[20][3] += 5e-4F;
  expect_complaint(c, "state 20 as stored: speed is beyond its limit of 2 by up to 0.0005");
}

// --- limits ---

struct LimitCase {
  std::string model;
  std::string parameter;
  double reached;
  std::string name;
};

class EveryLimit : public ::testing::TestWithParam<LimitCase> {};

INSTANTIATE_TEST_SUITE_P(Limits, EveryLimit,
                         ::testing::Values(LimitCase{"snake", "max_speed", 2.0, "speed"},
                                           LimitCase{"truck", "max_steering", 0.4, "steering"},
                                           LimitCase{"car", "max_acceleration", 2.0, "acceleration"},
                                           LimitCase{"car", "max_steering_rate", 2.0, "steering rate"},
                                           LimitCase{"kinematic_truck", "max_speed", 2.0, "speed"},
                                           LimitCase{"kinematic_truck", "max_steering", 0.4, "steering"},
                                           LimitCase{"unicycle", "max_speed", 2.0, "speed"},
                                           LimitCase{"unicycle", "max_turn_rate", 1.0, "turn rate"},
                                           LimitCase{"unicycle2", "max_speed", 2.0, "speed"},
                                           LimitCase{"unicycle2", "max_turn_rate", 1.0, "turn rate"},
                                           LimitCase{"unicycle2", "max_acceleration", 2.0, "acceleration"},
                                           LimitCase{"unicycle2", "max_turn_acceleration", 5.0, "turn acceleration"},
                                           LimitCase{"diff_drive", "max_wheel_speed", 9.0, "right wheel speed"},
                                           LimitCase{"diff_drive", "max_wheel_acceleration", 8.0,
                                                     "left wheel acceleration"}),
                         [](const auto& chosen) { return chosen.param.model + "_" + chosen.param.parameter; });

TEST_P(EveryLimit, ATenthOfAThousandthBeyondIsCaught) {
  const LimitCase& p = GetParam();
  expect_complaint(beyond(p.model, p.parameter, p.reached, 2e-4), ": " + p.name + " ");
}

TEST_P(EveryLimit, RoundingBeyondIsNot) {
  const LimitCase& p = GetParam();
  expect_holds(beyond(p.model, p.parameter, p.reached, 5e-5).verdict());
}

TEST(Limits, ReversingIsCaughtUnlessTheRobotMay) {
  const RobotSpec forward_only = robot("car");
  Case c = drive(
      forward_only,
      [](std::size_t, const Row&) {
        return Row{-1, 0};
      },
      5);
  expect_complaint(c, "speed is beyond its limit of 0 by up to 0.5");
  c.asked.robot.parameters["min_speed"] = -1;
  c.plan.robot = c.asked.robot;
  expect_holds(c.verdict());
}

TEST_P(EveryModel, ReversingIsCaughtUnlessTheRobotMay) {
  const RobotSpec& spec = GetParam();
  const auto back = [&](std::size_t, const Row&) { return spec.model == "diff_drive" ? Row{-1, -1} : Row{-0.5, 0}; };
  Case c = drive(spec, back, 5);
  c.asked.robot.parameters["min_speed"] = 0;
  c.plan.robot = c.asked.robot;
  expect_complaint(c, "speed is beyond its limit of 0 by up to ");
  c.asked.robot.parameters["min_speed"] = -0.6;
  c.plan.robot = c.asked.robot;
  expect_holds(c.verdict());
}

TEST(Limits, AHitchIsBentByWhatIsLeftOfFullTurns) {
  Case c = arc("truck", 2);
  for (std::vector<float>& state : c.plan.states) state.back() += static_cast<float>(2 * std::numbers::pi);
  expect_holds(c.verdict());
}

TEST(Limits, AFoldedHitchIsCaught) {
  const auto steer = [](std::size_t step, const Row&) { return step < 5 ? Row{4, 1} : Row{0, 0}; };
  Case c = drive(robot("truck", 1), steer, 40);
  expect_holds(c.verdict());
  c.asked.robot.parameters["max_hitch_angle"] = 0.5;  // the circle of this steering bends it to 0.58
  c.plan.robot = c.asked.robot;
  expect_complaint(c, "hitch angle 1 ");
}

TEST(Limits, AHitchFoldedOnlyBetweenTwoStatesIsCaught) {
  // In the last step the steering swings from one side to the other: the hitch bends further, then comes back.
  RobotSpec spec = robot("truck", 1);
  spec.parameters["max_steering"] = 1.5;
  spec.parameters["max_steering_rate"] = 24;
  const auto steer = [](std::size_t step, const Row&) -> Row {
    return step < 10 ? Row{2, 0} : step < 13 ? Row{0, 4} : Row{0, -24};
  };
  Case c = drive(spec, steer, 14);
  const auto bend = [](const auto& state) { return static_cast<double>(state[2] - state[5]); };
  const std::vector<float>& from = c.plan.states[13];
  const double ends = std::max(bend(from), bend(c.plan.states[14]));
  const double between = bend(simulate(spec, Row(from.begin(), from.end()), {0, -24}, 0.05));
  ASSERT_GT(between, ends + 0.01);
  c.asked.robot.parameters["max_hitch_angle"] = (ends + between) / 2;
  c.plan.robot = c.asked.robot;
  expect_complaint(c, "step 13 at 0.0");
}

TEST(Limits, HoldBetweenSubStepsToo) {
  const Dynamics dynamics(robot("unicycle2"));
  const auto complaints_of = [&](const Row& speeds) {
    Complaints complaints;
    LimitCheck limits(dynamics, complaints);
    Leg leg;
    for (const double speed : speeds) leg.states.push_back({0, 0, 0, speed, 0});
    limits.check_leg("step 7", leg, 0.1);
    return complaints.lines();
  };
  // The parabolas through these speeds, of which none is above 2.495, reach 2.4950 and 2.5051.
  EXPECT_THAT(complaints_of({2.4, 2.495, 2.4}), ElementsAre());
  EXPECT_THAT(complaints_of({2.4, 2.495, 2.49}),
              ElementsAre("step 7 at 0.05 s: speed is beyond its limit of 2.5 by up to 0.005125"));
}

// --- obstacles ---

Case snake_along_wall(double gap) {
  Case c = straight(robot("snake", 3));
  add_obstacle(c, rectangle(5, 20.25 + gap, 30, 21));
  return c;
}

TEST(Collision, AClearanceOfATenthOfAMillimetreIsEnough) {
  const Verdict verdict = snake_along_wall(1e-4).verdict();
  expect_holds(verdict);
  EXPECT_NEAR(verdict.clearance, 1e-4, 1e-6);
}

TEST(Collision, AnOverlapOfATenthOfAMillimetreIsCaught) {
  expect_complaint(snake_along_wall(-1e-4), "overlaps obstacles[0] by up to 0.0001 m");
}

TEST(Collision, TheClearanceIsThatOfTheNearestBody) {
  Case c = straight(robot("snake", 3));
  const double tail = 15 - 3 * 0.8;
  add_obstacle(c, rectangle(tail - 1, 20, tail - 0.35 - 0.123, 20.1));
  EXPECT_NEAR(c.verdict().clearance, 0.123, 1e-6);
}

// A robot that is smaller than the way of a sub-step: at 2 m/s one of 8 sub-steps of 0.1 s is 25 mm.
Case small_robot() {
  RobotSpec spec = robot("car");
  spec.bodies = {rectangle(-0.002, -0.002, 0.002, 0.002)};
  return straight(spec);
}

TEST(Collision, AWallOfAMillimetreBetweenTwoSubStepsIsCaught) {
  Case c = small_robot();
  const double stored = static_cast<double>(c.plan.states[20][0]);
  add_obstacle(c, rectangle(stored + 0.0125, 19, stored + 0.0135, 21));
  const Verdict verdict = c.verdict();
  EXPECT_THAT(verdict.complaints, Contains(HasSubstr("step 20 at 0 s: body 0 overlaps obstacles[0]")));
  EXPECT_EQ(verdict.clearance, 0);
}

TEST(Collision, AWallOfAMillimetreBetweenTwoStatesIsCaught) {
  Case c = small_robot();
  const double stored = static_cast<double>(c.plan.states[20][0]);
  add_obstacle(c, rectangle(stored + 0.11, 19, stored + 0.111, 21));
  expect_complaint(c, "step 20 at 0.05 s: body 0 overlaps obstacles[0]");
}

TEST(Collision, AJumpThroughAWallIsCaughtByTheStatesAndByTheirMotion) {
  Case c = straight(robot("car"));
  add_obstacle(c, rectangle(18, 10, 18.001, 30));
  const auto jump = [&](std::size_t i) { return static_cast<double>(c.plan.states[i][0]) > 17.6; };
  std::size_t first = 0;
  while (!jump(first)) ++first;
  for (std::size_t i = first; i < c.plan.states.size(); ++i) c.plan.states[i][0] += 1.2F;
  const Verdict verdict = c.verdict();
  EXPECT_THAT(verdict.complaints, Contains(HasSubstr("x differs by 1.2")));
  EXPECT_THAT(verdict.complaints, Contains(HasSubstr("overlaps obstacles[0]")));
}

TEST(Collision, AWallThatHidesInTheToleranceOfAStateIsCaught) {
  // A stored state may lie 0.9 mm beside the driven one: the wall of 0.4 mm stands in that gap.
  Case c = small_robot();
  const double stored = static_cast<double>(c.plan.states[20][1]);
  for (std::size_t i = 21; i < c.plan.states.size(); ++i) c.plan.states[i][1] += 9e-4F;
  add_obstacle(c, rectangle(10, stored + 0.00205, 30, stored + 0.00245));
  expect_complaint(c, "state 21 as stored: body 0 overlaps");
}

TEST(Collision, AWholeTurnInOneSubStepIsNotTakenForRest) {
  RobotSpec spec = robot("unicycle");
  const double rate = 2 * std::numbers::pi / 0.0125;  // the same pose at each of 8 sub-steps of 0.1 s
  spec.parameters["max_turn_rate"] = 600;
  Case c = drive(
      spec,
      [&](std::size_t, const Row&) {
        return Row{0, rate};
      },
      2, {20, 20}, 0);
  add_obstacle(c, rectangle(19.9, 20.3, 20.1, 20.4));  // beside the body, in the way of its corners
  expect_complaint(c, "step 0 at 0.0006592 s: body 0 overlaps obstacles[0]");
}

TEST(Collision, ACornerClippingACornerIsCaught) {
  // In its arc the body's outer front corner passes the tip of a wedge: 0.2 mm tells clear from clipped.
  Case c = drive(
      robot("unicycle"),
      [](std::size_t, const Row&) {
        return Row{1, 1};
      },
      15, {20, 20}, 0);
  const double radius = std::hypot(0.35, 1 + 0.25);  // of the corner around the arc's middle at (20, 21)
  const double angle = -0.3;
  const auto wedge = [&](double r) {
    const Point tip{20 + r * std::cos(angle), 21 + r * std::sin(angle)};
    return Ring{tip, {tip.x + 1, tip.y - 0.2}, {tip.x + 1, tip.y + 0.2}};
  };
  Case clear = c;
  add_obstacle(clear, wedge(radius + 1e-4));
  expect_holds(clear.verdict());
  EXPECT_NEAR(clear.verdict().clearance, 1e-4, 2.5e-5);
  add_obstacle(c, wedge(radius - 1e-4));
  expect_complaint(c, "overlaps obstacles[0]");
}

TEST(Collision, InsideAHoleIsFree) {
  Case c = straight(robot("snake", 3));
  add_obstacle(c, rectangle(2, 2, 38, 38), {rectangle(10, 19, 30, 21)});
  const Verdict verdict = c.verdict();
  expect_holds(verdict);
  EXPECT_NEAR(verdict.clearance, 0.75, 1e-6);
  c.workspace.min = {1, -2};  // holes have the map's coordinates, as outlines have
  expect_holds(c.verdict());
  EXPECT_NEAR(c.verdict().clearance, 0.75, 1e-6);
}

TEST(Collision, InTheRingAroundAHoleIsNot) {
  Case c = straight(robot("snake", 3));
  add_obstacle(c, rectangle(2, 2, 38, 38), {rectangle(10, 19, 18, 21)});
  expect_complaint(c, "overlaps obstacles[0]");
}

TEST(Collision, WhollyInsideAnObstacleIsCaught) {
  Case c = straight(robot("snake", 3));
  add_obstacle(c, rectangle(2, 2, 38, 38));
  expect_complaint(c, "start: body 0 overlaps obstacles[0]");
}

TEST(Collision, ARingThatCrossesItselfIsFilledByEvenOdd) {
  Case c = straight(robot("car"));
  add_obstacle(c, {{16, 18}, {20, 22}, {20, 18}, {16, 22}});  // a bow tie across the way
  expect_complaint(c, "overlaps obstacles[0]");
}

TEST(Collision, TheNotchOfARingThatCrossesItselfIsFree) {
  Case c = straight(robot("car"));
  add_obstacle(c, {{18, 10}, {38, 30}, {18, 30}, {38, 10}});  // a bow tie whose left notch the car drives into
  expect_holds(c.verdict());
}

TEST(Collision, WhatAnOutlineGoesRoundTwiceIsFree) {
  Case c = straight(robot("car"));
  // The outline goes round the inner square a second time, in the same direction.
  add_obstacle(c, {{2, 2}, {38, 2}, {38, 38}, {2, 38}, {2, 2}, {5, 15}, {35, 15}, {35, 25}, {5, 25}, {5, 15}});
  expect_holds(c.verdict());
}

TEST(Collision, OrientationDoesNotMatter) {
  Case c = snake_along_wall(-1e-3);
  std::ranges::reverse(c.workspace.obstacles[0].outer);
  expect_complaint(c, "overlaps obstacles[0] by up to 0.001 m");
}

TEST(Collision, AnObstacleOutOfTheBoundsIsNoError) {
  Case c = straight(robot("car"));
  add_obstacle(c, rectangle(-100, -100, -1, 200));
  expect_holds(c.verdict());
}

TEST(Collision, OutOfBoundsIsCaughtAndMeasured) {
  Case c = straight(robot("car"));
  c.workspace.max.y = 20.249;
  c.workspace.min.y = 0;
  expect_complaint(c, "body 0 is up to 0.001 m outside the bounds");
  EXPECT_NEAR(c.verdict().clearance, -1e-3, 1e-6);
  c.workspace.max.y = 20.251;
  expect_holds([&] {
    set_goal(c, rectangle(end_of(c).x - 1, 19.5, end_of(c).x + 1, 20.2));
    return c.verdict();
  }());
  EXPECT_NEAR(c.verdict().clearance, 1e-3, 1e-6);
}

TEST(Collision, AnObstacleThatIsNotFiniteIsAnInputError) {
  Case c = straight(robot("car"));
  add_obstacle(c, {{0, 0}, {1, 0}, {1, std::numeric_limits<double>::quiet_NaN()}});
  EXPECT_THROW(c.verdict(), InputError);
}

TEST(Collision, BoundsWithoutSizeAreAnInputError) {
  Case c = straight(robot("car"));
  c.workspace.max = c.workspace.min;
  EXPECT_THROW(c.verdict(), InputError);
}

// --- bodies against each other ---

// A snake with short hitches that steers as hard as it can until its head meets its tail.
Case coil(double gap, std::size_t steps = 150) {
  RobotSpec spec = robot("snake", 15);
  spec.parameters["self_collision_gap"] = gap;
  spec.parameters["max_steering"] = 1.4;
  spec.parameters["wheelbase"] = 2.0;
  const auto steer = [](std::size_t step, const Row&) { return step < 10 ? Row{1, 1} : Row{0, 0}; };
  return drive(spec, steer, steps);
}

// The least distance of two bodies that must not meet, in the stored states.
double least_distance(const Case& c) {
  const Dynamics dynamics(c.asked.robot);
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<float>& state : c.plan.states) {
    const std::vector<Frame> frames = dynamics.frames(State(state.begin(), state.end()));
    const auto placed = [&](std::size_t body) {
      Ring ring;
      for (const Point& point : c.asked.robot.bodies[body]) ring.push_back(frames[body].place(point));
      return hull_of(ring);
    };
    for_each_pair(dynamics, [&](std::size_t first, std::size_t second) {
      least = std::min(least, boost::geometry::distance(placed(first), placed(second)));
    });
  }
  return least;
}

TEST(SelfCollision, AHeadInItsTailIsCaught) {
  Case c = coil(4);
  const Verdict verdict = c.verdict();
  EXPECT_FALSE(verdict.holds);
  EXPECT_THAT(verdict.complaints, Contains(HasSubstr("meets body ")));
  EXPECT_EQ(verdict.self_clearance, 0);
}

TEST(SelfCollision, BodiesNearerThanTheGapAreNotTested) {
  const Verdict verdict = coil(16).verdict();
  expect_holds(verdict);
  EXPECT_EQ(verdict.self_clearance, std::numeric_limits<double>::infinity());
}

TEST(SelfCollision, ItsClearanceIsMeasured) {
  const Verdict verdict = straight(robot("snake", 15)).verdict();
  EXPECT_NEAR(verdict.self_clearance, 4 * 0.8 - 0.7, 1e-5);
  const Case bent = coil(4, 60);
  const double least = least_distance(bent);
  ASSERT_GT(least, 0.1);
  EXPECT_LE(bent.verdict().self_clearance, least + 1e-6);
  EXPECT_GT(bent.verdict().self_clearance, least - 0.05);
}

// --- maps of cells ---

TEST(Cells, AnEmptyMapHolds) {
  Case c = straight(robot("snake", 3));
  c.workspace.cells = cells(0.05);
  expect_holds(c.verdict());
}

TEST(Cells, AnOverlapByOneCellIsCaught) {
  // The body's side runs along y = 20.25, which is the lower side of row 405.
  Case c = straight(robot("snake", 3));
  c.workspace.cells = cells(0.05);
  occupy(*c.workspace.cells, 350, 405);
  occupy(*c.workspace.cells, 351, 405);
  for (Point& p : c.asked.robot.bodies[0]) p.y *= 1 - 1e-3;
  for (auto& body : c.asked.robot.bodies) body = c.asked.robot.bodies[0];
  c.plan.robot = c.asked.robot;
  expect_holds(c.verdict());
  EXPECT_NEAR(c.verdict().clearance, 0.25e-3, 1e-6);
  occupy(*c.workspace.cells, 350, 404);
  expect_complaint(c, "overlaps map row 404, columns 350 to 350");
}

// The map turned around the middle of the bounds, large enough to hold them.
CellMap turned(double yaw) {
  CellMap map = cells(0.05);
  map.columns = map.rows = 1200;
  map.occupied.assign(1200UL * 1200UL, 0);
  map.yaw = yaw;
  map.origin = {20 - 30 * (std::cos(yaw) - std::sin(yaw)), 20 - 30 * (std::sin(yaw) + std::cos(yaw))};
  return map;
}

TEST(Cells, AYawedMapHasItsCellsInItsOwnFrame) {
  const double yaw = 0.7;
  Case c = straight(robot("car"));
  c.workspace.cells = turned(yaw);
  expect_holds(c.verdict());
  // The cell under the world's point (17, 20), on the robot's way.
  const double dx = 17 - c.workspace.cells->origin.x;
  const double dy = 20 - c.workspace.cells->origin.y;
  const int column = static_cast<int>((std::cos(yaw) * dx + std::sin(yaw) * dy) / 0.05);
  const int row = static_cast<int>((std::cos(yaw) * dy - std::sin(yaw) * dx) / 0.05);
  occupy(*c.workspace.cells, column, row);
  expect_complaint(c, "overlaps map row " + std::to_string(row));
}

TEST(Cells, AYawedCellIsMeasuredExactly) {
  const double yaw = std::numbers::pi / 4;
  Case c = straight(robot("car"));
  c.workspace.cells = turned(yaw);
  // A cell stands on its corner; the lowest point of cell (600 + k, 600 + k) lies at (20, 20 + k * 0.05 * sqrt 2).
  occupy(*c.workspace.cells, 605, 605);
  EXPECT_NEAR(c.verdict().clearance, 5 * 0.05 * std::numbers::sqrt2 - 0.25, 1e-6);
}

TEST(Cells, OutsideOfTheMapIsNotFree) {
  Case c = straight(robot("car"));
  c.workspace.cells = cells(0.05);
  c.workspace.cells->rows = 404;  // up to y = 20.2
  c.workspace.cells->occupied.resize(404UL * 800UL);
  expect_complaint(c, "outside the bounds");
}

TEST(Cells, FarFromTheOriginNothingIsLost) {
  Case c = snake_along_wall(1e-4);
  const Point far{431000, 5411000};
  c.workspace.min = far;
  c.workspace.max = {far.x + 40, far.y + 40};
  c.workspace.cells = cells(0.05);
  c.workspace.cells->origin = far;
  for (Point& p : c.workspace.obstacles[0].outer) p = {p.x + far.x, p.y + far.y};
  for (Point& p : c.asked.goal) p = {p.x + far.x, p.y + far.y};
  c.asked.start.position = {far.x + 15, far.y + 20};
  c.plan.origin = far;
  expect_holds(c.verdict());
  EXPECT_NEAR(c.verdict().clearance, 1e-4, 1e-6);
}

TEST(Cells, AMapWhoseSizeLiesIsAnInputError) {
  Case c = straight(robot("car"));
  c.workspace.cells = cells(0.05);
  c.workspace.cells->rows += 1;
  EXPECT_THROW(c.verdict(), InputError);
}

// Asks for the heading that the plan ends with, but for `off` radians.
Case with_heading(Case c, double off, std::optional<double> hitches = {}) {
  c.asked.facing = GoalFacing{static_cast<double>(c.plan.states.back()[2]) + off, 0.1, false, hitches};
  c.plan.goal_facing = c.asked.facing;
  return c;
}

TEST_P(EveryModel, TheHeadingAtTheEndIsJudged) {
  const Case c = arc(GetParam().model, GetParam().links);
  expect_holds(with_heading(c, 0.09).verdict());
  EXPECT_NEAR(with_heading(c, 0.09).verdict().heading_error, 0.09, 1e-4);
  expect_complaint(with_heading(c, 0.11), "goal: the heading of the driven end is 0.11 rad from the one asked for");
  expect_complaint(with_heading(c, -0.11), "goal: the heading of the driven end is 0.11 rad from the one asked for");
  expect_holds(with_heading(c, 4 * std::numbers::pi).verdict());
  EXPECT_TRUE(std::isnan(c.verdict().heading_error));
}

TEST_P(EveryModel, EitherWayTheOppositeHeadingWillDo) {
  Case c = with_heading(arc(GetParam().model, GetParam().links), std::numbers::pi - 0.05);
  expect_complaint(c, "goal: the heading of the driven end is 3.092 rad");
  c.asked.facing->either_way = c.plan.goal_facing->either_way = true;
  expect_holds(c.verdict());
  EXPECT_NEAR(c.verdict().heading_error, 0.05, 1e-4);
}

TEST(Heading, TheHitchesAreJudged) {
  const Case c = arc("truck", 2);
  const std::vector<float>& end = c.plan.states.back();
  const double first = std::abs(static_cast<double>(end[2] - end[5]));
  const double second = std::abs(static_cast<double>(end[5] - end[6]));
  ASSERT_GT(first, 0.05);
  ASSERT_GT(second, 0.05);
  expect_holds(with_heading(c, 0, std::max(first, second) + 1e-3).verdict());
  expect_complaint(with_heading(c, 0, first - 1e-3), "goal: the hitch before body 1 of the driven end is bent by");
  if (second > first) {
    expect_complaint(with_heading(c, 0, second - 1e-3), "goal: the hitch before body 2 of the driven end is bent by");
  }
}

// The stored state may say what it wants: the controls are driven.
TEST(Heading, IsThatOfTheControls) {
  Case c = with_heading(arc("unicycle"), 0.104);
  c.plan.states.back()[2] += 0.0045F;
  expect_complaint(c, "goal: the heading of the driven end is 0.104 rad");
}

TEST(Heading, APlanMadeForAnotherIsRefused) {
  const char* const sentence = "goal: the plan was not made for the heading and the tolerances asked for";
  const Case good = with_heading(arc("car"), 0);
  for (const auto& change : std::vector<std::function<void(PlanFile&)>>{
           [](PlanFile& plan) { plan.goal_facing.reset(); }, [](PlanFile& plan) { plan.goal_facing->heading += 0.01; },
           [](PlanFile& plan) { plan.goal_facing->tolerance += 0.01; },
           [](PlanFile& plan) { plan.goal_facing->either_way = true; },
           [](PlanFile& plan) { plan.goal_facing->hitches = 0.1; }}) {
    Case c = good;
    change(c.plan);
    expect_complaint(c, sentence);
  }
}

// Sped up to 2 m/s, then braked for so many steps, 0.5 m/s each.
Case braked(std::size_t steps) {
  const auto steer = [&](std::size_t step, const Row&) -> Row {
    if (step < 10) return {2, 0};
    return step < 10 + steps ? Row{-5, 0} : Row{0, 0};
  };
  return drive(robot("car"), steer, 16, {15, 20}, 0);
}

TEST(EndSpeed, IsJudgedWhereItIsAsked) {
  Case moving = braked(2);
  expect_holds(moving.verdict());
  EXPECT_NEAR(moving.verdict().end_speed, 1, 1e-5);
  moving.asked.end_speed = 1;
  expect_holds(moving.verdict());
  moving.asked.end_speed = 0.98;
  expect_complaint(moving, "end: the driven end moves at 1 m/s, asked at most 0.98 m/s");
  Case still = braked(4);
  still.asked.end_speed = 0;
  expect_holds(still.verdict());
}

TEST(EndSpeed, OfADifferentialDriveIsItsFasterWheels) {
  Case spinning = drive(
      robot("diff_drive"),
      [](std::size_t step, const Row&) {
        return step < 2 ? Row{-3, 3} : Row{0, 0};
      },
      4);
  expect_holds(spinning.verdict());
  EXPECT_NEAR(spinning.verdict().end_speed, 0.06, 1e-5);
  spinning.asked.end_speed = 0;
  expect_complaint(spinning, "end: the driven end moves at 0.06 m/s");
}

TEST(EndSpeed, OfASecondOrderUnicycleIsThatOfItsEndsWhereItTurnsOnTheSpot) {
  Case turning = drive(
      robot("unicycle2"),
      [](std::size_t step, const Row&) {
        return step < 2 ? Row{0, -1} : Row{0, 0};
      },
      4);
  expect_holds(turning.verdict());
  EXPECT_NEAR(turning.verdict().end_speed, 0.07, 1e-5);
  turning.asked.end_speed = 0;
  expect_complaint(turning, "end: the driven end moves at 0.07 m/s");
}

TEST(EndSpeed, OfAUnicycleIsNone) {
  Case c = arc("unicycle");
  c.asked.end_speed = 0;
  expect_holds(c.verdict());
  EXPECT_EQ(c.verdict().end_speed, 0);
}

// The stored state may say what it wants: the controls are driven.
TEST(EndSpeed, IsThatOfTheControls) {
  Case c = braked(2);
  c.asked.end_speed = 0;
  c.plan.states.back()[3] = 0;
  expect_complaint(c, "end: the driven end moves at 1 m/s");
}

}  // namespace
}  // namespace krait::host::testing
