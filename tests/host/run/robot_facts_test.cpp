// SPDX-License-Identifier: Apache-2.0
// Turns, stops and time steps that krait robot reports, against geometry by hand and against the core's own dynamics.
#include "host/run/robot_facts.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "../every_robot.hpp"
#include "../scratch.hpp"
#include "host/robot_file/shipped.hpp"
#include "host/run/robots.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;

RobotSpec with(RobotSpec robot, std::initializer_list<std::pair<const char*, double>> changes) {
  for (const auto& [name, value] : changes) robot.parameters.at(name) = value;
  robot.bodies = default_bodies(robot);
  return robot;
}

RobotFacts facts(const RobotSpec& robot) { return facts_of("mine", robot, Parameters()); }

TEST(RobotFacts, ACarsTurnIsARightTriangle) {
  const RobotFacts car = facts(with(parse_robot("car"), {{"wheelbase", 2}, {"body_length", 3}, {"max_steering", 0.5}}));
  const double radius = 2 / std::tan(0.5);
  EXPECT_NEAR(car.lock_radius, radius, 1e-12);
  EXPECT_NEAR(car.tightest.radius, radius, 1e-12);
  EXPECT_NEAR(car.lock_outer, std::hypot(2.5, radius + 0.3), 1e-12);  // the front corner away from the centre
  EXPECT_NEAR(car.tightest.outer, car.lock_outer, 1e-12);
  EXPECT_NEAR(car.tightest.inner, radius - 0.3, 1e-12);  // the side beside the rear axle
  EXPECT_NEAR(car.tightest.swept_width, car.tightest.outer - car.tightest.inner, 1e-12);
  EXPECT_FALSE(car.folds_at_lock);
}

// A plan's steps are held to some micrometres, and single precision adds its own.
TEST(RobotFacts, APlansTimeStepsAreAccurate) {
  for (const char* name : {"car", "truck:2", "snake:5", "unicycle", "diff_drive", "husky", "semitrailer"}) {
    const double error = facts(parse_robot(name)).step_error;
    EXPECT_GT(error, 0) << name;
    EXPECT_LT(error, 1e-5) << name;
  }
}

TEST(RobotFacts, ACentreInsideOfABodyLeavesNoHole) {
  const RobotFacts car = facts(with(parse_robot("car"), {{"wheelbase", 0.1}, {"max_steering", 1.5}}));
  EXPECT_LT(car.lock_radius, 0.3);
  EXPECT_EQ(car.tightest.inner, 0);
}

TEST(RobotFacts, WhatNeverStandsStillTurnsOnACircle) {
  const RobotFacts robot = facts(with(parse_robot("unicycle"), {{"min_speed", 0.5}, {"max_turn_rate", 0.25}}));
  EXPECT_EQ(robot.least_speed, 0.5);
  EXPECT_NEAR(robot.lock_radius, 2, 1e-12);
  EXPECT_NEAR(robot.tightest.outer, std::hypot(0.25, 2.2), 1e-12);
  EXPECT_NEAR(robot.tightest.swept_width, std::hypot(0.25, 2.2) - 1.8, 1e-12);
  EXPECT_EQ(facts(parse_robot("unicycle")).least_speed, 0);
}

TEST(RobotFacts, WhatTurnsOnTheSpotSweepsADisc) {
  for (const char* name : {"unicycle", "diff_drive"}) {
    const RobotFacts robot = facts(parse_robot(name));
    EXPECT_EQ(robot.lock_radius, 0) << name;
    EXPECT_NEAR(robot.tightest.outer, std::hypot(0.25, 0.2), 1e-12) << name;
    EXPECT_NEAR(robot.tightest.swept_width, 2 * std::hypot(0.25, 0.2), 1e-12) << name;
  }
}

// Trailers that fold at full lock drive wider turns only.
TEST(RobotFacts, NoModelsTurnIsSharperThanItsCoreDrives) {
  for (const std::string& name : every_robot(2)) {
    const RobotSpec robot = parse_robot(name);
    const float core = CoreRobot(robot).view().turning_radius(1.0F);
    const double lock = lock_radius(robot);
    EXPECT_LT(lock, static_cast<double>(core) + 1e-6) << name;
    if (robot.links > 0) continue;
    EXPECT_NEAR(lock, static_cast<double>(core), 1e-6) << name;
  }
}

// Whatever a ROBOT.json may say is within the library's ranges; no more of the two angles that have an end there.
TEST(RobotFacts, TheCoreTakesEveryParameterOfItsRange) {
  const auto sound = [](const RobotSpec& robot) { return CoreRobot(robot).view().sound(); };
  for (const std::string& text : every_robot(1)) {
    const std::string model = parse_robot(text).model;
    for (const auto& [name, normal] : default_parameters(model)) {
      const auto [least, most] = range_of(model, name);
      RobotSpec robot = parse_robot(text);
      if (name == "min_speed" && most > 0) robot.parameters.at("max_speed") = most;
      EXPECT_TRUE(sound(with(robot, {{name.c_str(), least}}))) << model << " " << name;
      EXPECT_TRUE(sound(with(robot, {{name.c_str(), most}}))) << model << " " << name;
      if (name == "max_steering" || name == "max_hitch_angle") {
        EXPECT_FALSE(sound(with(robot, {{name.c_str(), most + 1e-6}}))) << model << " " << name;
      }
    }
  }
}

// No trailer follows at more than a right angle, whatever folding is allowed.
TEST(RobotFacts, FoldingFurtherThanARightAngleAllowsNoTighterTurn) {
  const RobotSpec right = with(parse_robot("truck:2"), {{"max_hitch_angle", 1.5707963}});
  const RobotSpec further = with(parse_robot("truck:2"), {{"max_hitch_angle", 3.0}});
  EXPECT_NEAR(facts(further).tightest.radius, facts(right).tightest.radius, 1e-6);
}

// Drives the core's robot with its steering held until no hitch angle changes any more.
std::vector<double> driven_hitch_angles(const RobotSpec& spec, double radius) {
  return CoreRobot(spec).visit([&](const auto& robot) {
    std::vector<float> state(static_cast<std::size_t>(robot.state_size()), 0.0F);
    std::vector<float> rates(state.size());
    std::vector<double> angles;
    if constexpr (requires { robot.parameters().trailers; }) {
      state[3] = 1.0F;
      state[4] = static_cast<float>(std::atan(spec.parameters.at("wheelbase") / radius));
      const float rest[2] = {0.0F, 0.0F};
      for (int i = 0; i < 400'000; ++i) {
        robot.derivative(StateView(state.data(), robot.state_size()), ControlView(rest, 2),
                         StateRef(rates.data(), robot.state_size()));
        for (std::size_t k = 2; k < state.size(); ++k) state[k] += 5e-4F * rates[k];
        if (state[2] > 3.0F) {  // floats are finer near 0, and only differences of headings matter
          for (std::size_t k = 2; k < state.size(); ++k) state[k] -= k == 3 || k == 4 ? 0.0F : 3.0F;
        }
      }
      for (int k = 0; k < spec.links; ++k) {
        const auto at = static_cast<std::size_t>(k);
        angles.push_back(static_cast<double>((k == 0 ? state[2] : state[4 + at]) - state[5 + at]));
      }
    }
    return angles;
  });
}

TEST(RobotFacts, AChainsSteadyTurnIsWhereItsDynamicsComeToRest) {
  for (const char* name : {"truck:2", "snake:3", "semitrailer", "b_triple"}) {
    SCOPED_TRACE(name);
    const RobotSpec robot = parse_robot(name);
    const SteadyTurn turn = facts(robot).tightest;
    ASSERT_EQ(turn.hitch_angles.size(), static_cast<std::size_t>(robot.links));
    const std::vector<double> driven = driven_hitch_angles(robot, turn.radius);
    for (std::size_t k = 0; k < driven.size(); ++k) EXPECT_THAT(turn.hitch_angles[k], DoubleNear(driven[k], 2e-3));
  }
}

// R^2 > N d^2 (truck.hpp): at R = d the second trailer has nowhere to roll.
TEST(RobotFacts, TrailersFoldWhereTheLockIsTooTight) {
  EXPECT_TRUE(facts(parse_robot("truck:2")).folds_at_lock);
  EXPECT_NEAR(facts(parse_robot("truck:2")).tightest.radius, 1.1 * 0.8 * std::sqrt(2), 1e-9);
  const double gentle = std::atan(0.8 / 2.0);
  EXPECT_FALSE(facts(with(parse_robot("truck:2"), {{"max_steering", gentle}})).folds_at_lock);
  EXPECT_NEAR(facts(with(parse_robot("truck:2"), {{"max_steering", gentle}})).tightest.radius, 2, 1e-12);
  EXPECT_TRUE(facts(with(parse_robot("truck:2"), {{"max_steering", gentle}, {"max_hitch_angle", 0.3}})).folds_at_lock);
  for (const ShippedRobot& shipped : shipped_robots()) {
    EXPECT_FALSE(facts(parse_robot(shipped.name)).folds_at_lock) << shipped.name;
  }
}

TEST(RobotFacts, StoppingFollowsFromSpeedAndAcceleration) {
  const RobotFacts car = facts(parse_robot("car"));
  EXPECT_NEAR(car.stopping_time, 0.5, 1e-12);
  EXPECT_NEAR(car.stopping_distance, 0.625, 1e-12);
  const RobotFacts wheels = facts(parse_robot("diff_drive"));
  EXPECT_NEAR(wheels.top_speed, 0.96, 1e-12);
  EXPECT_NEAR(wheels.stopping_distance, 0.24, 1e-12);
  EXPECT_TRUE(facts(parse_robot("unicycle")).stops_at_once);
}

TEST(RobotFacts, TheTimeStepIsTheCores) {
  const RobotFacts snake = facts(parse_robot("snake:15"));
  EXPECT_EQ(snake.tree_parts, 1);
  EXPECT_EQ(snake.plan_parts, 2);
  EXPECT_NEAR(snake.fastest_rate, 2.5 / 0.8, 1e-6);
  EXPECT_NEAR(snake.longest_time_step, 0.1, 1e-6);
  const RobotFacts racer = facts(with(parse_robot("car"), {{"max_speed", 100}}));
  EXPECT_NEAR(racer.longest_time_step, 16 * 0.32 / (100 / 0.8), 1e-4);
}

TEST(RobotFacts, ASteeredAxleOutsideOfItsBodyIsMeasured) {
  EXPECT_EQ(axle_warning(with(parse_robot("truck:1"), {{"body_length", 1.2}, {"wheelbase", 0.9}})),
            "the steered axle lies 0.3 m outside of body 0: a truck's box is centred on its rear axle; bodies in a "
            "ROBOT.json place it");
  EXPECT_EQ(axle_warning(parse_robot("car")), "");
  for (const ShippedRobot& shipped : shipped_robots()) {
    EXPECT_EQ(axle_warning(parse_robot(shipped.name)), "") << shipped.name;
  }
}

TEST(RobotFacts, ARobotThatTheCoreRefusesIsRefused) {
  RobotSpec robot = parse_robot("car");
  robot.bodies[0] = {{0, 0}, {500, 0}, {500, 1}};
  EXPECT_EQ(error_of([&] { facts(robot); }),
            "mine: body 0 reaches 500 m from its axle: bodies must lie within 100 m of their axles; were centimetres "
            "meant?");
  robot.bodies[0] = {{0, 0}, {1, 0}, {1, 1}, {1 - 1e-5, 1 + 5e-5}};
  EXPECT_EQ(error_of([&] { facts(robot); }),
            "mine: body 0: a side is shorter than 0.1 mm, or a corner next to straight");
}

TEST(RobotFacts, ARobotInCentimetresIsAskedAboutByItsSize) {
  RobotSpec robot = parse_robot("truck:1");
  for (const auto& [size, value] : {std::pair("body_width", 240.0), std::pair("body_length", 450.5)}) {
    robot.parameters[size] = value;
    robot.bodies = default_bodies(robot);
    EXPECT_EQ(error_of([&] { require_usable("c.json", robot); }),
              printed("c.json: %s %.7g m: bodies must lie within 100 m of their axles; were centimetres meant?", size,
                      value));
  }
  EXPECT_NO_THROW(require_usable("truck:1", parse_robot("truck:1")));
}

}  // namespace
}  // namespace krait::host
