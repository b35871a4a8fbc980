// SPDX-License-Identifier: Apache-2.0
// The campaign's own equations of motion, held against what is known in closed form, and its bounds of motion against
// fine integration.
#include "drive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace krait::campaign {
namespace {

Robot chain(Model model, int trailers) {
  Robot robot;
  robot.model = model;
  robot.chain.trailers = trailers;
  return robot;
}

State hold(const Robot& robot, const State& from, const double* u, double time) {
  const Equations equations(robot);
  Drive drive(equations);
  return drive.hold(from, u, time).back();
}

TEST(Drive, UnicycleGoesInACircle) {
  Robot robot;
  robot.model = Model::unicycle;
  const double u[2] = {2, 0.5};
  const State end = hold(robot, State{1, 2, 0.3}, u, 7);
  EXPECT_NEAR(end[0], 1 + 4 * (std::sin(3.8) - std::sin(0.3)), 1e-8);
  EXPECT_NEAR(end[1], 2 - 4 * (std::cos(3.8) - std::cos(0.3)), 1e-8);
  EXPECT_NEAR(end[2], 3.8, 1e-12);
}

TEST(Drive, DifferentialDriveTurnsOnTheSpot) {
  Robot robot;
  robot.model = Model::diff_drive;
  const double u[2] = {0, 0};
  const State end = hold(robot, State{1, 2, 0.3, -3, 3}, u, 1);
  EXPECT_NEAR(end[0], 1, 1e-12);
  EXPECT_NEAR(end[2], 0.3 + 0.08 * 6 / 0.36, 1e-6);
}

TEST(Drive, CarGoesInACircleOfItsWheelbaseOverTheTangent) {
  const Robot robot = chain(Model::car, 0);
  const double u[2] = {0, 0}, radius = 0.8 / std::tan(0.6), angle = 3 * std::cos(0.6) * 2 / radius;
  const State end = hold(robot, State{0, 0, 0, 3, 0.6}, u, 2);
  EXPECT_NEAR(end[0], radius * std::sin(angle), 1e-6);
  EXPECT_NEAR(end[1], radius * (1 - std::cos(angle)), 1e-6);
}

// tan(phi / 2) shrinks by e for every hitch length that the car goes straight on.
TEST(Drive, TrailerFollowsATractrix) {
  for (const Model model : {Model::snake, Model::truck}) {
    const Robot robot = chain(model, 1);
    const double u[2] = {0, 0};
    State from{};
    from[3] = 2;
    from[5] = -1.2;
    const State end = hold(robot, from, u, 1.5);
    EXPECT_NEAR(std::tan(-end[5] / 2), std::tan(0.6) * std::exp(-2 * 1.5 / 0.8), 1e-6);
  }
}

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

State any_state(std::mt19937_64& random, int size) {
  State state{};
  state[2] = uniform(random, -3, 3);
  state[3] = uniform(random, -2.5, 2.5);
  state[4] = uniform(random, -1, 1);
  for (std::size_t i = 5; i < static_cast<std::size_t>(size); ++i) {
    state[i] = (i == 5 ? state[2] : state[i - 1]) + uniform(random, -1.5, 1.5);
  }
  return state;
}

TEST(Equations, WheelsOfATruckDoNotSlip) {
  std::mt19937_64 random(1);
  const Equations equations(chain(Model::truck, 4));
  for (int i = 0; i < 100; ++i) {
    const State state = any_state(random, 9);
    const double u[2] = {0, 0}, step = 1e-6;
    State rates{}, later = state;
    equations.rates(state, u, rates);
    for (std::size_t c = 0; c < 9; ++c) later[c] += step * rates[c];
    Frames now, then;
    equations.place(state, now);
    equations.place(later, then);
    for (std::size_t k = 0; k < 5; ++k) {
      const double across = (then[k].y - now[k].y) * now[k].cos - (then[k].x - now[k].x) * now[k].sin;
      EXPECT_NEAR(across / step, 0, 1e-4);
    }
  }
}

TEST(Equations, NoBodyGoesFurtherThanItsReach) {
  std::mt19937_64 random(2);
  double closest = 0;  // share of the bound that was used
  for (const Model model : {Model::snake, Model::truck}) {
    const Equations equations(chain(model, 6));
    for (int i = 0; i < 2000; ++i) {
      const State from = any_state(random, 11);
      const double u[2] = {uniform(random, -5, 5), uniform(random, -4, 4)}, time = uniform(random, 0.001, 0.3);
      constexpr int kParts = 40;
      double path[7] = {}, turn[7] = {};
      State state = from;
      Frames at, next;
      equations.place(state, at);
      const Frames first = at;
      for (int part = 0; part < kParts; ++part) {
        const State then = advanced(equations, state, u, time / kParts);
        equations.place(then, next);
        for (std::size_t k = 0; k < 7; ++k) {
          path[k] += std::hypot(next[k].x - at[k].x, next[k].y - at[k].y);
          const std::size_t heading = k == 0 ? 2 : 4 + k;
          turn[k] += std::abs(then[heading] - state[heading]);
        }
        state = then;
        at = next;
      }
      Reaches reaches;
      equations.reach(from, first, state, at, u, time, reaches);
      for (std::size_t k = 0; k < 7; ++k) {
        EXPECT_LE(path[k], reaches[k].path + 1e-9);
        EXPECT_LE(turn[k], reaches[k].turn + 1e-9);
        closest = std::max(closest, path[k] / (reaches[k].path + 1e-12));
      }
    }
  }
  EXPECT_GT(closest, 0.9);
}

}  // namespace
}  // namespace krait::campaign
