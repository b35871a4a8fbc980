// SPDX-License-Identifier: Apache-2.0
// What controllers ask for, where it can be computed by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "krait/krait.hpp"
#include "motion/drive.hpp"
#include "robot_oracle.hpp"

namespace krait::test::robot_steering_test {
namespace {

TEST(RobotSteering, AUnicycleBacksNoFasterThanItCan) {
  UnicycleParameters p;
  p.min_speed = -0.25F;
  const Unicycle robot(p);
  const float state[] = {0, 0, 0};
  Target behind;
  behind.point = {-5, 0};
  for (const float share : {1.0F, 0.5F}) {
    behind.speed = -share;
    Steering steering;
    float control[2];
    robot.steer(StateView(state, 3), behind, steering, ControlRef(control, 2));
    EXPECT_FLOAT_EQ(control[0], -0.25F * share);
    EXPECT_NEAR(control[1], 0.0F, 1e-5F);
  }
}

TEST(RobotSteering, AUnicycleStandsWhileItTurnsToAPointBehindIt) {
  UnicycleParameters p;
  p.min_speed = -0.25F;
  const Unicycle robot(p);
  const float state[] = {0, 0, 0};
  Target behind;
  behind.point = {-5, 1};
  Steering steering;
  float control[2];
  robot.steer(StateView(state, 3), behind, steering, ControlRef(control, 2));
  EXPECT_EQ(control[0], 0.0F);
  EXPECT_GT(control[1], 0.0F);
}

// Steered toward a point far ahead in that direction; returns the headings' errors after each step.
template <class R>
std::vector<float> turned_to(float heading, const R& robot, const std::vector<float>& state, float speed,
                             float sways = 1e-3F) {
  const SinCos direction = math::sin_cos(heading);
  detail::Drive drive;
  drive.assign(robot, 0.1F);
  drive.begin(state.data());
  Target target;
  target.point = {1e4F * direction.cos, 1e4F * direction.sin};
  target.speed = speed;
  drive.aim(target);
  std::vector<float> errors;
  for (int i = 0; i < 200; ++i) {
    drive.step();
    EXPECT_TRUE(robot.within_limits(StateView(drive.state(), 5)));
    errors.push_back(drive.state()[2] - heading);
  }
  EXPECT_NEAR(errors.back(), errors[errors.size() - 2], sways);
  return errors;
}

TEST(RobotSteering, ASecondOrderUnicycleTurnsToItsTargetWithoutPassingIt) {
  for (const float speed : {1.0F, 1e-3F}) {
    for (const float heading : {0.05F, 0.4F, 1.5F, 3.1F}) {
      for (const float error : turned_to(heading, Unicycle2(sluggish()), {0, 0, 0, 0, 0}, speed))
        EXPECT_LT(error, 2e-3F);
      EXPECT_NEAR(turned_to(heading, Unicycle2(sluggish()), {0, 0, 0, 0, 0}, speed).back(), 0.0F, 2e-3F);
      EXPECT_NEAR(turned_to(heading, Unicycle2(Unicycle2Parameters()), {0, 0, 0, 0, 0}, speed).back(), 0.0F, 2e-3F);
    }
  }
}

// Its wheels take four seconds to their top speed.
TEST(RobotSteering, ADifferentialDriveWithSlowWheelsHardlyPassesItsTarget) {
  DifferentialDriveParameters p;
  p.wheel_radius = 0.05F;
  p.track_width = 1.0F;
  p.max_wheel_speed = 10.0F;
  p.max_wheel_acceleration = 2.5F;
  for (const float heading : {0.05F, 0.4F, 1.5F, 3.1F}) {
    const std::vector<float> errors = turned_to(heading, DifferentialDrive(p), {0, 0, 0, 0, 0}, 1e-3F);
    for (const float error : errors) EXPECT_LT(error, 0.02F);
    EXPECT_NEAR(errors.back(), 0.0F, 0.02F);
  }
}

// Its wheels take seconds to their lock, within which it drives several wheelbases, and as long to be straight again.
TEST(RobotSteering, ACarWithSlowWheelsHardlyPassesItsTarget) {
  ChainParameters p = Car::defaults();
  p.max_speed = 8.0F;
  p.max_steering_rate = 0.3F;
  for (const float heading : {0.05F, 0.4F, 1.5F, 3.1F}) {
    for (const float side : {1.0F, -1.0F}) {
      const std::vector<float> errors = turned_to(side * heading, Car(p), {0, 0, 0, 8, 0}, 1.0F, 0.02F);
      for (const float error : errors) EXPECT_LT(side * error, 0.02F);
      EXPECT_NEAR(errors.back(), 0.0F, 0.02F);
    }
  }
}

// It turns by half a radian more until its turn rate is 0, which brings it nearer to what lies behind it.
TEST(RobotSteering, ASecondOrderUnicycleTurnsOnWhereItCannotTurnBack) {
  for (const float side : {1.0F, -1.0F}) {
    const std::vector<float> turning = {0, 0, 0, 0, 0.5F * side};
    const std::vector<float> on = turned_to(-2.9F * side, Unicycle2(sluggish()), turning, 1.0F);
    EXPECT_NEAR(on[9] - on[0], 0.45F * side, 1e-3F);  // it does not brake
    EXPECT_NEAR(on.back(), 2.0F * kPi * side, 2e-3F);
    const std::vector<float> back = turned_to(-2.0F * side, Unicycle2(sluggish()), turning, 1.0F);
    EXPECT_LT((back[9] - back[0]) * side, 0.4F);
    EXPECT_NEAR(back.back(), 0.0F, 2e-3F);
  }
}

TEST(RobotSteering, ASecondOrderUnicycleDrivesSlowerTowardWhatLiesAside) {
  Unicycle2Parameters p;
  p.min_speed = -0.5F;
  p.max_acceleration = 1e3F;
  const Unicycle2 robot(p);
  const float state[] = {0, 0, 0, 0, 0};
  const auto speed = [&](Vec2 point, float share) {
    Target target;
    target.point = point;
    target.speed = share;
    Steering steering;
    float control[2];
    robot.steer(StateView(state, 5), target, steering, ControlRef(control, 2));
    return control[0] * target.dt;
  };
  EXPECT_NEAR(speed({5, 0}, 1.0F), 1.0F, 1e-3F);
  EXPECT_NEAR(speed({5, 0}, 0.5F), 0.5F, 1e-3F);
  EXPECT_NEAR(speed({5, 5}, 1.0F), 0.5F, 1e-3F);
  EXPECT_NEAR(speed({-1, 5}, 1.0F), 0.0F, 1e-3F);
  EXPECT_NEAR(speed({-5, 0}, -1.0F), -0.5F, 1e-3F);
}

// A turn by 90 degrees from rest to rest takes it some 2 s up to its largest turn rate and as long down from it, in
// which it turns by a radian, and the rest of the angle at that rate.
TEST(RobotSteering, ASecondOrderUnicycleDrivesOnThroughATurnThatIsNotTheSharpest) {
  const auto speed = [&](Vec2 point, float turn, float share) {
    const float state[] = {0, 0, 0, 0.25F * share, 0};
    Target target;
    target.point = point;
    target.speed = share;
    target.turn = turn;
    target.dt = 1.0F;
    Steering steering;
    float control[2];
    Unicycle2(sluggish()).steer(StateView(state, 5), target, steering, ControlRef(control, 2));
    return state[3] + control[0];
  };
  const float takes = 0.5F * kPi / 0.5F + 0.5F / 0.245F;
  EXPECT_NEAR(speed({0, 1}, 0.8F, 1.0F), 1.0F / (2.5F * 0.64F * takes), 1e-4F);
  EXPECT_NEAR(speed({0, -1}, 0.8F, 1.0F), 1.0F / (2.5F * 0.64F * takes), 1e-4F);
  EXPECT_NEAR(speed({0, 1}, 0.8F, -1.0F), -1.0F / (2.5F * 0.64F * takes), 1e-4F);
  EXPECT_NEAR(speed({0, 1}, 0.6F, 1.0F), 1.0F / (2.5F * 0.36F * takes), 1e-4F);
  EXPECT_GT(speed({0, 1}, 0.3F, 1.0F), 0.49F);
  const float little = 2.0F * std::sqrt(0.25F * kPi / 0.245F);  // 45 degrees, without reaching the largest turn rate
  EXPECT_NEAR(speed({0.5F, 0.5F}, 0.8F, 1.0F), std::sqrt(0.5F) / (2.5F * 0.64F * little), 1e-4F);
  EXPECT_GT(speed({1, 0}, 0.99F, 1.0F), 0.49F);  // straight ahead
  EXPECT_LT(speed({0, 1}, 1.0F, 1.0F), 0.01F);   // the sharpest: on the spot
}

// A turn by 90 degrees takes it pi / 2 over its turn rate, in seconds.
TEST(RobotSteering, AUnicycleDrivesOnThroughATurnThatIsNotTheSharpest) {
  UnicycleParameters p;
  p.min_speed = -0.5F;
  p.max_turn_rate = 0.5F;
  const Unicycle robot(p);
  const auto speed = [&](Vec2 point, float turn, float share) {
    const float state[] = {0, 0, 0};
    Target target;
    target.point = point;
    target.speed = share;
    target.turn = turn;
    Steering steering;
    float control[2];
    robot.steer(StateView(state, 3), target, steering, ControlRef(control, 2));
    return control[0];
  };
  const float takes = 0.5F * kPi / 0.5F;
  EXPECT_NEAR(speed({0, 1}, 0.8F, 1.0F), 1.0F / (2.5F * 0.64F * takes), 1e-4F);
  EXPECT_NEAR(speed({0, -1}, 0.8F, 1.0F), 1.0F / (2.5F * 0.64F * takes), 1e-4F);
  EXPECT_NEAR(speed({0, 2}, 0.8F, 0.7F), 2.0F / (2.5F * 0.64F * takes), 1e-4F);  // the way in the time, at any speed
  EXPECT_NEAR(speed({0, 1}, 0.8F, -1.0F), -1.0F / (2.5F * 0.64F * takes), 1e-4F);
  EXPECT_EQ(speed({0, 1}, 0.2F, 1.0F), 1.0F);
  EXPECT_EQ(speed({1, 0}, 0.99F, 1.0F), 1.0F);          // straight ahead
  EXPECT_NEAR(speed({0, 1}, 1.0F, 1.0F), 0.0F, 1e-5F);  // the sharpest: on the spot
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

// Wheels that speed up, or brake, with all that they have would not turn.
TEST(RobotSteering, ADifferentialDriveTurnsBeforeItsSpeedChanges) {
  DifferentialDriveParameters p;
  p.max_wheel_acceleration = 10.0F;
  const DifferentialDrive robot(p);
  const auto control = [&](float wheels, Vec2 point, float share) {
    const float state[] = {0, 0, 0, wheels, wheels};
    Target target;
    target.point = point;
    target.speed = share;
    Steering steering;
    std::vector<float> u(2);
    robot.steer(StateView(state, 5), target, steering, ControlRef(u.data(), 2));
    return u;
  };
  const float error = std::atan(0.05F);
  const float half_turn = 0.5F * (3.0F + 0.05F * 0.1F) * error * p.track_width / p.wheel_radius;
  const std::vector<float> faster = control(0, {5, 0.25F}, 1);  // both are less than it could do alone
  EXPECT_NEAR(faster[1], 9.8F, 1e-3F);
  EXPECT_NEAR(0.5F * (faster[1] - faster[0]) * 0.1F, half_turn, 1e-3F);
  const std::vector<float> slower = control(8, {5, 0.25F}, 0.1F);
  EXPECT_NEAR(slower[0], -9.8F, 1e-3F);
  EXPECT_NEAR(0.5F * (slower[1] - slower[0]) * 0.1F, half_turn, 1e-3F);
  const std::vector<float> aside = control(5, {0, 5}, 1);  // the turn needs all
  EXPECT_NEAR(aside[0], -9.8F, 1e-3F);
  EXPECT_NEAR(aside[1], 9.8F, 1e-3F);
}

// Steered to rest for long enough; returns the state that it then stands in.
template <class R>
std::vector<float> stopped(const R& robot, std::vector<float> state, Vec2 toward) {
  const int size = robot.state_size();
  detail::Drive drive;
  drive.assign(robot, 0.1F);
  drive.begin(state.data());
  Target target;
  target.point = toward;
  target.speed = 0.0F;
  drive.aim(target);
  for (int i = 0; i < 100 && robot.speed(StateView(drive.state(), size)) > 1e-3F; ++i) {
    const float before = robot.speed(StateView(drive.state(), size));
    drive.step();
    EXPECT_LT(robot.speed(StateView(drive.state(), size)), before);
    EXPECT_TRUE(robot.within_limits(StateView(drive.state(), size)));
  }
  EXPECT_LE(robot.speed(StateView(drive.state(), size)), 1e-3F);
  return {drive.state(), drive.state() + size};
}

template <class R>
void expect_stopping_way(const R& robot, const std::vector<float>& state, Vec2 toward, float tolerance) {
  const std::vector<float> end = stopped(robot, state, toward);
  EXPECT_NEAR(end[0] - state[0], robot.stopping_way(StateView(state.data(), robot.state_size())), tolerance);
}

TEST(RobotSteering, ACarStopsWhereItsStoppingWayEnds) {
  ChainParameters p;
  p.trailers = 2;
  p.min_speed = -1.5F;
  for (const float speed : {2.5F, 1.2F, 0.3F, -0.4F, -1.5F}) {
    const std::vector<float> state = {1, 2, 0, speed, 0, 0, 0};
    const Vec2 target{speed < 0.0F ? -50.0F : 50.0F, 2};
    expect_stopping_way(Truck(p), state, target, 0.01F);
    expect_stopping_way(Snake(p), state, target, 0.01F);
    const Truck truck(p);
    EXPECT_EQ(truck.speed(StateView(state.data(), 7)), math::absolute(speed));
  }
  EXPECT_NEAR(Truck(p).stopping_way(StateView(std::vector<float>{0, 0, 0, 2, 1, 0, 0}.data(), 7)), 0.4F * 0.5403F,
              1e-4F);
}

// On a turn a wheel that is slower stops sooner.
TEST(RobotSteering, ADifferentialDriveStopsWithoutTurningToItsTarget) {
  const DifferentialDrive robot(DifferentialDriveParameters{});
  for (const float speed : {12.0F, 5.0F, -3.0F, -12.0F}) {
    expect_stopping_way(robot, {1, 2, 0, speed, speed}, {1, 20}, 0.02F);
  }
  EXPECT_FLOAT_EQ(robot.speed(StateView(std::vector<float>{0, 0, 0, -12, 3}.data(), 5)), 0.96F);
  const std::vector<float> end = stopped(robot, {1, 2, 0, 6, 6}, {1, 20});
  EXPECT_NEAR(end[2], 0.0F, 1e-5F);
}

TEST(RobotSteering, ASecondOrderUnicycleStopsMovingAndTurning) {
  const Unicycle2 robot(Unicycle2Parameters{});
  for (const float speed : {1.0F, 0.3F, -0.3F, -1.0F}) {
    expect_stopping_way(robot, {1, 2, 0, speed, 0}, {1, 20}, 0.01F);
  }
  const std::vector<float> end = stopped(robot, {1, 2, 0, 0.1F, 2}, {1, -20});
  EXPECT_NEAR(end[2], 0.51F, 5e-3F);
  EXPECT_FLOAT_EQ(robot.speed(StateView(std::vector<float>{0, 0, 0, -0.2F, 2}.data(), 5)), 0.5F);
  EXPECT_FLOAT_EQ(robot.speed(StateView(std::vector<float>{0, 0, 0, -0.2F, 0.4F}.data(), 5)), 0.2F);
  Unicycle2Parameters forwards;
  forwards.min_speed = 0.0F;
  stopped(Unicycle2(forwards), {1, 2, 0, 1, -2}, {1, 20});
}

// The control of a kinematic truck whose trailers are bent as `state` says.
Vec2 steered(const KinematicTruckParameters& p, std::vector<float> state, const Target& target) {
  const KinematicTruck robot(p);
  state.resize(static_cast<std::size_t>(robot.state_size()), 0.0F);
  Steering steering;
  float control[2] = {9, 9};
  robot.steer(StateView(state.data(), robot.state_size()), target, steering, ControlRef(control, 2));
  return {control[0], control[1]};
}

Target toward(Vec2 point, float speed = 1.0F) {
  Target target;
  target.point = point;
  target.speed = speed;
  return target;
}

TEST(RobotSteering, AKinematicTruckDrivesAtTheSpeedAskedForAndStopsAtOnce) {
  KinematicTruckParameters p;
  p.min_speed = -0.5F;
  EXPECT_FLOAT_EQ(steered(p, {}, toward({5, 0}, 0.5F)).x, 1.25F);
  EXPECT_FLOAT_EQ(steered(p, {}, toward({-5, 0}, -1.0F)).x, -0.5F);
  EXPECT_FLOAT_EQ(steered(p, {}, toward({-5, 0}, -0.5F)).x, -0.25F);
  EXPECT_NEAR(steered(p, {}, toward({-5, 0}, -1.0F)).y, 0.0F, 1e-5F);
  EXPECT_LT(steered(p, {}, toward({-5, -1}, -1.0F)).y, -0.1F);
  EXPECT_EQ(length(steered(p, {}, toward({0, 5}, 0.0F))), 0.0F);
}

// After a step it faces the target and is not beyond; its sharpest turns are those of its lock, and a share of one is
// that of its curvature.
TEST(RobotSteering, AKinematicCarTurnsNoFurtherThanToItsTarget) {
  KinematicTruckParameters p;
  p.wheelbase = 0.2F;
  EXPECT_NEAR(2.5F * 0.1F * std::tan(steered(p, {}, toward({10, 1})).y) / p.wheelbase, 0.0997F, 2e-3F);
  p.wheelbase = 0.8F;
  EXPECT_FLOAT_EQ(steered(p, {}, toward({0, 5})).y, p.max_steering);
  EXPECT_FLOAT_EQ(steered(p, {}, toward({0, -5})).y, -p.max_steering);
  Target gentle = toward({0, 5});
  gentle.turn = 0.25F;
  EXPECT_NEAR(std::tan(steered(p, {}, gentle).y), 0.25F * std::tan(p.max_steering), 1e-5F);
}

// A trailer is turned as sharply as the wheels go while it is straight, and no more sharply than it follows when it is
// bent to 1.2 rad; more of them always to what they follow.
TEST(RobotSteering, AKinematicTrucksTrailersBoundItsSteering) {
  KinematicTruckParameters p;
  p.trailers = 1;
  p.max_speed = 1.0F;
  EXPECT_FLOAT_EQ(steered(p, {}, toward({0, 5})).y, p.max_steering);
  EXPECT_NEAR(std::tan(steered(p, {0, 0, 0, -1.2F}, toward({0, 5})).y), std::sin(1.2F), 1e-4F);
  EXPECT_FLOAT_EQ(steered(p, {0, 0, 0, 1.2F}, toward({0, 5})).y, p.max_steering);
  p.trailers = 4;
  EXPECT_NEAR(std::tan(steered(p, {}, toward({0, 5})).y), 1.0F / 2.2F, 1e-5F);
}

TEST(RobotSteering, AUnicycleThatShallStopStandsStill) {
  const Unicycle robot(UnicycleParameters{});
  const float state[] = {0, 0, 0};
  Target beside;
  beside.point = {0, 5};
  beside.speed = 0.0F;
  Steering steering;
  float control[2] = {1, 1};
  robot.steer(StateView(state, 3), beside, steering, ControlRef(control, 2));
  EXPECT_EQ(control[0], 0.0F);
  EXPECT_EQ(control[1], 0.0F);
}

TEST(RobotSteering, AUnicycleWithALeastSpeedKeepsItAndTurnsOnACircle) {
  UnicycleParameters p;
  p.min_speed = 0.25F;
  const Unicycle robot(p);
  EXPECT_FALSE(robot.reversible());
  EXPECT_FLOAT_EQ(robot.turning_radius(), p.min_speed / p.max_turn_rate);
  const float state[] = {0, 0, 0};
  for (const float speed : {0.0F, 0.1F, 0.5F, 1.0F}) {
    for (const Vec2 point : {Vec2{5, 0}, Vec2{0, 5}, Vec2{-5, 0.1F}}) {
      Target target;
      target.point = point;
      target.speed = speed;
      Steering steering;
      float control[2] = {};
      robot.steer(StateView(state, 3), target, steering, ControlRef(control, 2));
      const bool ahead = point.x > 0.0F && speed > p.min_speed;
      EXPECT_FLOAT_EQ(control[0], ahead ? speed * p.max_speed : p.min_speed) << speed << " to " << point.x;
    }
  }
}

}  // namespace
}  // namespace krait::test::robot_steering_test
