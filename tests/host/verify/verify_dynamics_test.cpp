// SPDX-License-Identifier: Apache-2.0
// The verifier's own equations of motion against geometry and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host/verify/dynamics.hpp"
#include "plans.hpp"

namespace krait::host::testing {
namespace {

// A bent robot in full motion.
State random_state(const Dynamics& dynamics, std::mt19937& generator) {
  std::uniform_real_distribution<double> any(-0.8, 0.8);
  State state(dynamics.state_size());
  for (double& value : state) value = any(generator);
  if (state.size() > 3) state[3] = 1.5;
  return state;
}

Point turned(const Point& p, double angle) {
  return {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
}

TEST(Dynamics, DoNotDependOnTheDirectionOfTheAxes) {
  std::mt19937 generator(1);
  for (const RobotSpec& spec : every_robot(15)) {
    const Dynamics dynamics(spec);
    const State state = random_state(dynamics, generator);
    const Control control{0.7, 0.4};
    const double angle = 1.1;
    State other = state;
    const Point position = turned({state[0], state[1]}, angle);
    other[0] = position.x;
    other[1] = position.y;
    for (std::size_t i = 2; i < state.size(); ++i) {
      const bool heading = i == 2 || i + static_cast<std::size_t>(spec.links) >= state.size();
      if (heading) other[i] += angle;
    }
    const State rate = dynamics.derivative(state, control);
    const State other_rate = dynamics.derivative(other, control);
    const Point velocity = turned({rate[0], rate[1]}, angle);
    EXPECT_NEAR(other_rate[0], velocity.x, 1e-12) << spec.model;
    EXPECT_NEAR(other_rate[1], velocity.y, 1e-12) << spec.model;
    for (std::size_t i = 2; i < state.size(); ++i) EXPECT_NEAR(other_rate[i], rate[i], 1e-12) << spec.model;
  }
}

// The largest sideways speed of an axle, by finite differences of the frames.
double slip(const Dynamics& dynamics, const State& state, const Control& control = {0, 0}) {
  const State rate = dynamics.derivative(state, control);
  const double h = 1e-6;
  const auto moved = [&](double time) {
    State s = state;
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += time * rate[i];
    return dynamics.frames(s);
  };
  const auto before = moved(-h);
  const auto at = dynamics.frames(state);
  const auto after = moved(h);
  double worst = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double vx = (after[i].origin.x - before[i].origin.x) / (2 * h);
    const double vy = (after[i].origin.y - before[i].origin.y) / (2 * h);
    worst = std::max(worst, std::abs(at[i].cos * vy - at[i].sin * vx));
  }
  return worst;
}

TEST(Dynamics, NoAxleOfATruckSlipsSideways) {
  std::mt19937 generator(2);
  const Dynamics dynamics(robot("truck", 5));
  for (int i = 0; i < 100; ++i) EXPECT_LT(slip(dynamics, random_state(dynamics, generator)), 1e-8);
}

TEST(Dynamics, NoAxleOfAKinematicTruckSlipsSideways) {
  std::mt19937 generator(4);
  const Dynamics dynamics(robot("kinematic_truck", 5));
  for (int i = 0; i < 100; ++i) EXPECT_LT(slip(dynamics, random_state(dynamics, generator), {1.5, 0.6}), 1e-8);
}

TEST(Dynamics, ASnakesTrailersSlipAsInThePaper) {
  std::mt19937 generator(3);
  const Dynamics dynamics(robot("snake", 5));
  EXPECT_GT(slip(dynamics, random_state(dynamics, generator)), 1e-3);
}

TEST(Dynamics, AFrontWheelRollsWhereItPoints) {
  const Dynamics dynamics(robot("car"));
  const State state{0, 0, 0.4, 1.5, 0.6};
  const State rate = dynamics.derivative(state, {0, 0});
  const double wheelbase = 0.8;  // velocity of the point one wheelbase ahead of the rear axle
  const double vx = rate[0] - wheelbase * std::sin(0.4) * rate[2];
  const double vy = rate[1] + wheelbase * std::cos(0.4) * rate[2];
  EXPECT_NEAR(vx, 1.5 * std::cos(1.0), 1e-12);
  EXPECT_NEAR(vy, 1.5 * std::sin(1.0), 1e-12);
}

TEST(Dynamics, AKinematicTruckTurnsOnACircleOfItsWheelbaseOverTheTangent) {
  const Dynamics dynamics(robot("kinematic_truck"));
  const double radius = 0.8 / std::tan(0.6);
  const State end = dynamics.integrate({1, 2, 0.3}, {1.5, 0.6}, 0.1, 8).back();
  EXPECT_NEAR(end[2], 0.3 + 0.15 / radius, 1e-12);
  EXPECT_NEAR(end[0], 1 + radius * (std::sin(end[2]) - std::sin(0.3)), 1e-12);
  EXPECT_NEAR(end[1], 2 - radius * (std::cos(end[2]) - std::cos(0.3)), 1e-12);
}

TEST(Dynamics, AUnicycleDrivesACircle) {
  const Dynamics dynamics(robot("unicycle"));
  const State end = dynamics.integrate({1, 2, 0.3}, {2, 0.5}, 0.1, 8).back();
  EXPECT_NEAR(end[0], 1 + 4 * (std::sin(0.35) - std::sin(0.3)), 1e-12);
  EXPECT_NEAR(end[1], 2 - 4 * (std::cos(0.35) - std::cos(0.3)), 1e-12);
  EXPECT_NEAR(end[2], 0.35, 1e-12);
}

TEST(Dynamics, ASecondOrderUnicycleChangesSpeedAndTurnRateEvenly) {
  const Dynamics dynamics(robot("unicycle2"));
  const State ahead = dynamics.integrate({0, 0, 0, 1, 0}, {-2, 0}, 1.0, 8).back();
  EXPECT_NEAR(ahead[0], 0, 1e-12);
  EXPECT_NEAR(ahead[3], -1, 1e-12);
  const State around = dynamics.integrate({0, 0, 0, 0, 1}, {0, -1}, 1.0, 8).back();
  EXPECT_NEAR(around[2], 0.5, 1e-12);
  EXPECT_NEAR(around[4], 0, 1e-12);
  const State circle = dynamics.integrate({1, 2, 0.3, 2, 0.5}, {0, 0}, 0.1, 8).back();
  EXPECT_NEAR(circle[0], 1 + 4 * (std::sin(0.35) - std::sin(0.3)), 1e-12);
  EXPECT_NEAR(circle[1], 2 - 4 * (std::cos(0.35) - std::cos(0.3)), 1e-12);
}

TEST(Dynamics, ADifferentialDriveTurnsOnTheSpotWithOppositeWheels) {
  const Dynamics dynamics(robot("diff_drive"));
  const State end = dynamics.integrate({0, 0, 0, -2, 2}, {0, 0}, 1.0, 8).back();
  EXPECT_NEAR(end[0], 0, 1e-12);
  EXPECT_NEAR(end[2], 0.1 * 4 / 0.4, 1e-12);
}

TEST(Dynamics, TrailersHangOneHitchBehind) {
  const Dynamics dynamics(robot("truck", 2));
  const auto frames = dynamics.frames({1, 2, 0.5, 0, 0, 0.2, -0.4});
  EXPECT_NEAR(frames[1].origin.x, 1 - 0.8 * std::cos(0.2), 1e-12);
  EXPECT_NEAR(frames[2].origin.y, 2 - 0.8 * std::sin(0.2) + 0.8 * std::sin(0.4), 1e-12);
}

TEST(Dynamics, TrailersOfAKinematicTruckHangOneHitchBehind) {
  const Dynamics dynamics(robot("kinematic_truck", 2));
  const auto frames = dynamics.frames({1, 2, 0.5, 0.2, -0.4});
  EXPECT_NEAR(frames[1].origin.x, 1 - 0.8 * std::cos(0.2), 1e-12);
  EXPECT_NEAR(frames[2].origin.y, 2 - 0.8 * std::sin(0.2) + 0.8 * std::sin(0.4), 1e-12);
}

TEST(Dynamics, TheIntegratorIsOfEighthOrder) {
  const Dynamics dynamics(robot("snake", 3));
  const State start{0, 0, 0.3, 2, 0.5, 0.6, 0.1, -0.5};
  const auto end = [&](std::size_t steps) { return dynamics.integrate(start, {1, 0.5}, 0.8, steps).back(); };
  const State truth = end(256);
  const auto error = [&](const State& state) {
    double square = 0;
    for (std::size_t i = 0; i < state.size(); ++i) square += (state[i] - truth[i]) * (state[i] - truth[i]);
    return std::sqrt(square);
  };
  EXPECT_NEAR(std::log2(error(end(4)) / error(end(8))), 8.0, 0.6);
  EXPECT_LT(error(end(8)), 1e-10);
}

}  // namespace
}  // namespace krait::host::testing
