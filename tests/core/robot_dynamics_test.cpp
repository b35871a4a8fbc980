// SPDX-License-Identifier: Apache-2.0
// The models' derivatives, their integration and the placement of their bodies against double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "robot/shape.hpp"
#include "robot_oracle.hpp"

namespace krait::test::robot_dynamics_test {
namespace {

template <class R>
class RobotDynamics : public ::testing::Test {
 protected:
  // Calls check(robot, state, control) for random states and controls of every instance.
  template <class Check>
  static void for_random(int count, float dt, Check check) {
    std::mt19937 random(1);
    for (const R& robot : instances<R>()) {
      ASSERT_TRUE(robot.sound());
      for (int i = 0; i < count; ++i) {
        const auto s = random_state(robot, random);
        check(robot, s, random_control(robot, s, dt, random));
      }
    }
  }
};
TYPED_TEST_SUITE(RobotDynamics, Models, ModelNames);

TYPED_TEST(RobotDynamics, SatisfiesTheConcept) {
  static_assert(RobotModel<TypeParam>);
  for (const TypeParam& robot : instances<TypeParam>()) {
    EXPECT_LE(robot.state_size(), TypeParam::kMaxState);
    EXPECT_LE(robot.control_size(), TypeParam::kMaxControl);
    EXPECT_LE(robot.body_count(), TypeParam::kMaxBodies);
    EXPECT_EQ(detail::first_bad_of_robot(robot), Argument::none);
  }
}

TYPED_TEST(RobotDynamics, DerivativeIsTheFormula) {
  this->for_random(2000, 0.1F, [](const auto& robot, const auto& s, const auto& u) {
    const auto got = derivative(robot, s, u);
    const auto expected = rate(robot, doubles(s), doubles(u));
    ASSERT_EQ(got.size(), expected.size());
    for (std::size_t i = 0; i < got.size(); ++i)
      ASSERT_NEAR(wide(got[i]), expected[i], 3e-6 * (1 + std::abs(expected[i]))) << i;
  });
}

// The longest of the steps turn angles by more than a small angle's sine is good for.
TYPED_TEST(RobotDynamics, StepIsRungeKuttas) {
  for (const float dt : {0.01F, 0.1F, 0.4F, 1.0F}) {
    this->for_random(1000, dt, [dt](const auto& robot, const auto& s, const auto& u) {
      const auto got = step(robot, s, u, dt);
      const auto expected = rk4(robot, doubles(s), doubles(u), wide(dt));
      for (std::size_t i = 0; i < got.size(); ++i)
        ASSERT_NEAR(wide(got[i]), expected[i], 3e-6 * (1 + std::abs(expected[i]))) << i << " dt " << dt;
    });
  }
}

// Bit for bit, though long chains may be integrated in lanes and short ones body by body.
TYPED_TEST(RobotDynamics, TheFrontOfAChainMovesByItself) {
  if constexpr (kTows<TypeParam>) {
    for (const float dt : {0.01F, 0.1F, 0.4F}) {
      this->for_random(300, dt, [dt](const auto& robot, const auto& s, const auto& u) {
        Pose poses[TypeParam::kMaxBodies];
        robot.place(StateView(s.data(), robot.state_size()), poses);
        const auto moved = [&](int size) {
          std::vector<float> d(static_cast<std::size_t>(size));
          const StateView front(s.data(), size);
          typename TypeParam::Lead lead;
          robot.integrate_lead(front, poses, ControlView(u.data(), 2), dt, lead, d.data());
          robot.integrate_rest(front, poses, dt, lead, d.data());
          return d;
        };
        const std::vector<float> whole = moved(robot.state_size());
        for (int size = TypeParam::kCarState; size < robot.state_size(); ++size) {
          const std::vector<float> front = moved(size);
          ASSERT_TRUE(std::equal(front.begin(), front.end(), whole.begin())) << size << " components, dt " << dt;
        }
      });
    }
  }
}

TYPED_TEST(RobotDynamics, StepIsCloseToTheTrueMotion) {
  this->for_random(300, 0.1F, [](const auto& robot, const auto& s, const auto& u) {
    const auto got = step(robot, s, u, 0.1F);
    Numbers expected = doubles(s);
    constexpr int kParts = 50;
    for (int i = 0; i < kParts; ++i) expected = rk4(robot, expected, doubles(u), wide(0.1F) / kParts);
    for (std::size_t i = 0; i < got.size(); ++i) ASSERT_NEAR(wide(got[i]), expected[i], 5e-4) << i;
  });
}

TYPED_TEST(RobotDynamics, MotionTurnsAndMovesWithTheFrame) {
  std::mt19937 random(2);
  this->for_random(1000, 0.1F, [&](const auto& robot, const auto& s, const auto& u) {
    const double turn = uniform(random, -3, 3), dx = uniform(random, -5, 5), dy = uniform(random, -5, 5);
    const double c = std::cos(turn), sn = std::sin(turn);
    const auto moved = [&](const std::vector<float>& state) {
      Numbers result = doubles(state);
      result[0] = c * wide(state[0]) - sn * wide(state[1]) + dx;
      result[1] = sn * wide(state[0]) + c * wide(state[1]) + dy;
      result[2] += turn;
      if constexpr (kTows<TypeParam>) {
        for (std::size_t i = TypeParam::kCarState; i < result.size(); ++i) result[i] += turn;
      }
      return result;
    };
    const Numbers start = moved(s), expected = moved(step(robot, s, u, 0.1F));
    const auto got = step(robot, std::vector<float>(start.begin(), start.end()), u, 0.1F);
    for (std::size_t i = 0; i < got.size(); ++i) ASSERT_NEAR(wide(got[i]), expected[i], 2e-5) << i;
  });
}

TYPED_TEST(RobotDynamics, BodiesArePlacedOnTheirAxles) {
  this->for_random(1000, 0.1F, [](const auto& robot, const auto& s, const auto&) {
    Pose poses[TypeParam::kMaxBodies];
    robot.place(StateView(s.data(), robot.state_size()), poses);
    const auto expected = frames(robot, doubles(s));
    ASSERT_EQ(static_cast<std::size_t>(robot.body_count()), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      ASSERT_NEAR(wide(poses[k].position.x), expected[k].x, 3e-5) << k;
      ASSERT_NEAR(wide(poses[k].position.y), expected[k].y, 3e-5) << k;
      ASSERT_NEAR(wide(poses[k].heading.cos), std::cos(expected[k].angle), 2e-7) << k;
      ASSERT_NEAR(wide(poses[k].heading.sin), std::sin(expected[k].angle), 2e-7) << k;
    }
  });
}

// Speed of every axle across its own direction while the state moves along its derivative.
template <class R>
Numbers lateral_speeds(const R& robot, const std::vector<float>& s, const std::vector<float>& u) {
  const auto ds = derivative(robot, s, u);
  constexpr double kStep = 1e-5;
  Numbers before = doubles(s), after = doubles(s);
  for (std::size_t i = 0; i < s.size(); ++i) {
    before[i] -= kStep * wide(ds[i]);
    after[i] += kStep * wide(ds[i]);
  }
  const auto from = frames(robot, before), to = frames(robot, after), now = frames(robot, doubles(s));
  Numbers result;
  for (std::size_t k = 0; k < now.size(); ++k) {
    const double vx = (to[k].x - from[k].x) / (2 * kStep), vy = (to[k].y - from[k].y) / (2 * kStep);
    result.push_back(std::abs(-std::sin(now[k].angle) * vx + std::cos(now[k].angle) * vy));
  }
  return result;
}

template <class R>
class RobotWithoutSlip : public RobotDynamics<R> {};
using Rolling = ::testing::Types<Truck, KinematicTruck, Car, Unicycle, Unicycle2, DifferentialDrive>;
TYPED_TEST_SUITE(RobotWithoutSlip, Rolling, ModelNames);

TYPED_TEST(RobotWithoutSlip, NoAxleMovesAcrossItself) {
  this->for_random(1000, 0.1F, [](const auto& robot, const auto& s, const auto& u) {
    for (const double speed : lateral_speeds(robot, s, u)) ASSERT_LT(speed, 2e-5);
  });
}

TEST(RobotDynamicsSnake, TrailersSlipByTheSpeedThatTheSteeringTakes) {
  ChainParameters p;
  p.trailers = 1;
  const Snake snake(p);
  // Straight, wheels turned: the trailer's axle is pulled along at v cos psi and turns as if at v.
  const std::vector<float> s = {0, 0, 0, 2, 0.8F, 0.5F};
  const auto speeds = lateral_speeds(snake, s, {0, 0});
  EXPECT_LT(speeds[0], 2e-5);
  EXPECT_NEAR(speeds[1], 2 * (1 - std::cos(0.8)) * std::sin(0.5), 1e-4);
}

TEST(RobotDynamicsTruck, FrontWheelsRollWhereTheyPoint) {
  const Truck truck{ChainParameters{}};
  std::mt19937 random(4);
  for (int i = 0; i < 1000; ++i) {
    const auto s = random_state(truck, random);
    const auto ds = doubles(derivative(truck, s, {0, 0}));
    const double length = wide(truck.parameters().wheelbase), theta = wide(s[2]), psi = wide(s[4]);
    const double vx = ds[0] - length * std::sin(theta) * ds[2], vy = ds[1] + length * std::cos(theta) * ds[2];
    ASSERT_NEAR(-std::sin(theta + psi) * vx + std::cos(theta + psi) * vy, 0, 1e-5);
    ASSERT_NEAR(std::cos(theta + psi) * vx + std::sin(theta + psi) * vy, wide(s[3]), 1e-5);
  }
}

// With its steering angle held it moves as a truck does that holds its own and whose rear axle is as fast.
TEST(RobotDynamicsKinematicTruck, MovesAsATruckThatHoldsItsSteering) {
  std::mt19937 random(6);
  for (const KinematicTruck& robot : instances<KinematicTruck>()) {
    ChainParameters p;
    p.trailers = robot.parameters().trailers;
    p.wheelbase = robot.parameters().wheelbase;
    p.hitch_length = robot.parameters().hitch_length;
    const Truck truck(p);
    for (int i = 0; i < 300; ++i) {
      const auto s = random_state(robot, random);
      const auto u = random_control(robot, s, 0.1F, random);
      std::vector<float> held = {s[0], s[1], s[2], u[0] / std::cos(u[1]), u[1]};
      held.insert(held.end(), s.begin() + 3, s.end());
      auto expected = step(truck, held, {0, 0}, 0.1F);
      expected.erase(expected.begin() + 3, expected.begin() + 5);
      const auto got = step(robot, s, u, 0.1F);
      for (std::size_t k = 0; k < got.size(); ++k) ASSERT_NEAR(got[k], expected[k], 1e-5F) << k;
    }
  }
}

// A model without integrate_lead whose first two components turn around the origin.
struct Turning : Unicycle {
  Turning() : Unicycle(UnicycleParameters()) {}
  void derivative(StateView s, ControlView, StateRef ds) const { ds << s[1], -s[0], 0.0F; }
};

// A step of fourth order is off by dt^5 / 120 here, one of third order by dt^4 / 24.
TEST(RobotDynamicsOfAUser, AreIntegratedInFourthOrder) {
  const Turning robot;
  const float state[] = {1, 0, 0};
  const float control[] = {0, 0};
  for (const float dt : {0.25F, 0.5F, 1.0F}) {
    float change[3];
    detail::runge_kutta(robot, StateView(state, 3), ControlView(control, 2), dt, change);
    const double error = std::hypot(1 + wide(change[0]) - std::cos(wide(dt)), wide(change[1]) + std::sin(wide(dt)));
    EXPECT_LE(error, std::pow(wide(dt), 5) / 100 + 1e-6) << dt;
  }
}

TEST(RobotDynamicsUnicycle2, TurnsOnACircleAtConstantRates) {
  const Unicycle2 robot(Unicycle2Parameters{});
  std::vector<float> s = {0, 0, 0, 0.8F, 1.6F};  // centre at (0, 0.5)
  for (int i = 0; i < 200; ++i) {
    s = step(robot, s, {0, 0}, 0.05F);
    ASSERT_NEAR(std::hypot(wide(s[0]), wide(s[1]) - 0.5), 0.5, 1e-4);
  }
  EXPECT_NEAR(wide(s[2]), 16, 1e-4);
}

TEST(RobotDynamicsUnicycle2, ChangesSpeedAndTurnRateAsTheControlSays) {
  const Unicycle2 robot(Unicycle2Parameters{});
  const std::vector<float> ahead = step(robot, {0, 0, 0, 0.5F, 0}, {-2, 0}, 0.5F);
  EXPECT_NEAR(wide(ahead[0]), 0, 1e-6);
  EXPECT_NEAR(wide(ahead[3]), -0.5, 1e-6);
  const std::vector<float> around = step(robot, {0, 0, 0, 0, 1}, {0, -4}, 0.1F);
  EXPECT_NEAR(wide(around[2]), 0.08, 1e-6);
  EXPECT_NEAR(wide(around[4]), 0.6, 1e-6);
  EXPECT_EQ(around[0], 0.0F);
}

TEST(RobotDynamicsCar, TurnsOnACircleOfItsWheelbaseOverTheTangent) {
  const Car car(Car::defaults());
  const auto p = car.parameters();
  std::vector<float> s = {0, 0, 0, 1, 0.5F};
  const double radius = wide(p.wheelbase) / std::tan(0.5);  // centre at (0, radius)
  for (int i = 0; i < 200; ++i) {
    s = step(car, s, {0, 0}, 0.05F);
    ASSERT_NEAR(std::hypot(wide(s[0]), wide(s[1]) - radius), radius, 1e-4);
  }
}

TEST(RobotDynamicsCar, HasNoTrailersAndItsBodyOnTheMiddleOfTheWheelbase) {
  ChainParameters p = Car::defaults();
  p.trailers = 5;
  const Car car(p);
  EXPECT_EQ(car.state_size(), 5);
  EXPECT_EQ(car.body_count(), 1);
  const Polygon body = car.body(0);
  float sum = 0;
  for (int i = 0; i < 4; ++i) sum += body[i].x;
  EXPECT_FLOAT_EQ(sum / 4, 0.5F * p.wheelbase);
}

}  // namespace
}  // namespace krait::test::robot_dynamics_test
