// SPDX-License-Identifier: Apache-2.0
// Limits hold under steering, exactly; and states outside them are recognised.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "krait/robots/detail/defaults.hpp"
#include "robot/shape.hpp"
#include "robot_oracle.hpp"

namespace krait::test::robot_limits_test {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

template <class R>
class RobotLimits : public ::testing::Test {};
TYPED_TEST_SUITE(RobotLimits, Models, ModelNames);

// Whether all but the hitch angles, which steering does not promise, are inside.
bool speeds_inside(const Chain& r, const std::vector<float>& s) {
  const ChainParameters& p = r.parameters();
  return s[3] >= p.min_speed && s[3] <= p.max_speed && std::abs(s[4]) <= p.max_steering;
}
bool speeds_inside(const KinematicTruck&, const std::vector<float>&) { return true; }
bool speeds_inside(const Unicycle&, const std::vector<float>&) { return true; }
bool speeds_inside(const Unicycle2& r, const std::vector<float>& s) {
  const Unicycle2Parameters& p = r.parameters();
  return s[3] >= p.min_speed && s[3] <= p.max_speed && std::abs(s[4]) <= p.max_turn_rate;
}
bool speeds_inside(const DifferentialDrive& r, const std::vector<float>& s) {
  return std::abs(s[3]) <= r.parameters().max_wheel_speed && std::abs(s[4]) <= r.parameters().max_wheel_speed;
}

template <class R>
void expect_limits_held(const R& robot, float dt, int steps, std::mt19937& random) {
  auto s = random_state(robot, random);
  Steering steering;
  Target target;
  for (int i = 0; i < steps; ++i) {
    if (i % 20 == 0) {
      steering = {};
      target.point = {uniform_float(random, -10, 10), uniform_float(random, -10, 10)};
      target.speed =
          uniform_float(random, 0.05, 1) * (detail::reversible(robot) && below(random, 3) == 0 ? -1.0F : 1.0F);
      target.dt = dt;
    }
    std::vector<float> u(2);
    robot.steer(StateView(s.data(), robot.state_size()), target, steering, ControlRef(u.data(), 2));
    const auto limits = control_limits(robot);
    for (std::size_t k = 0; k < 2; ++k) {
      ASSERT_GE(u[k], limits[k].low) << "control " << k << " dt " << dt;
      ASSERT_LE(u[k], limits[k].high) << "control " << k << " dt " << dt;
    }
    s = step(robot, s, u, dt);
    ASSERT_TRUE(speeds_inside(robot, s)) << "dt " << dt << " step " << i << " v "
                                         << s[std::min<std::size_t>(3, s.size() - 1)];
    if (!robot.within_limits(StateView(s.data(), robot.state_size()))) s = random_state(robot, random);
  }
}

TYPED_TEST(RobotLimits, HoldUnderSteeringFromRandomStates) {
  std::mt19937 random(1);
  for (const TypeParam& robot : instances<TypeParam>()) {
    for (const float dt : {0.001F, 0.02F, 0.1F, 0.37F, 1.0F}) {
      for (int i = 0; i < 10; ++i) expect_limits_held(robot, dt, 300, random);
    }
  }
}

// Bit for bit, whoever finds the frames.
TYPED_TEST(RobotLimits, SteeringByTheFramesGivesTheSameControl) {
  std::mt19937 random(2);
  for (const TypeParam& robot : instances<TypeParam>()) {
    for (int i = 0; i < 2000; ++i) {
      const auto s = random_state(robot, random);
      const StateView view(s.data(), robot.state_size());
      std::vector<Pose> poses(static_cast<std::size_t>(robot.body_count()));
      robot.place(view, poses.data());
      Target target;
      target.point = {uniform_float(random, -10, 10), uniform_float(random, -10, 10)};
      target.speed = uniform_float(random, detail::reversible(robot) ? -1.0F : 0.05F, 1);
      Steering fresh[2];
      std::vector<float> alone(2), framed(2);
      robot.steer(view, target, fresh[0], ControlRef(alone.data(), 2));
      detail::steer(robot, view, poses.data(), target, fresh[1], ControlRef(framed.data(), 2));
      ASSERT_EQ(alone, framed) << i;
    }
  }
}

TYPED_TEST(RobotLimits, RestIsInsideThem) {
  for (const TypeParam& robot : instances<TypeParam>()) {
    std::vector<float> s(static_cast<std::size_t>(robot.state_size()), kNan);
    if constexpr (kTows<TypeParam>) {
      robot.rest({1, 2}, 0.5F, nullptr, s.data());
    } else {
      robot.rest({1, 2}, 0.5F, s.data());
    }
    EXPECT_TRUE(robot.within_limits(StateView(s.data(), robot.state_size())));
    EXPECT_EQ(s[0], 1.0F);
    EXPECT_EQ(s[1], 2.0F);
    EXPECT_EQ(s[2], 0.5F);
  }
}

TYPED_TEST(RobotLimits, NanOrInfinityAnywhereIsOutside) {
  std::mt19937 random(3);
  for (const TypeParam& robot : instances<TypeParam>()) {
    const auto sound = random_state(robot, random);
    ASSERT_TRUE(robot.within_limits(StateView(sound.data(), robot.state_size())));
    for (std::size_t i = 0; i < sound.size(); ++i) {
      for (const float bad : {kNan, kInfinity, -kInfinity}) {
        auto s = sound;
        s[i] = bad;
        EXPECT_FALSE(robot.within_limits(StateView(s.data(), robot.state_size()))) << i << " " << bad;
      }
    }
  }
}

// Beyond kMaxAngle the core has no sine: such a heading cannot be placed, so it is no state.
TYPED_TEST(RobotLimits, AnglesWithoutASineAreOutside) {
  for (const TypeParam& robot : instances<TypeParam>()) {
    for (const float heading : {8193.0F, -1e6F, 1e30F}) {
      std::vector<float> s(static_cast<std::size_t>(robot.state_size()), 0.0F);
      s[2] = heading;
      if constexpr (kTows<TypeParam>) {
        for (std::size_t i = TypeParam::kCarState; i < s.size(); ++i) s[i] = heading;
      }
      EXPECT_FALSE(robot.within_limits(StateView(s.data(), robot.state_size()))) << heading;
    }
  }
}

TYPED_TEST(RobotLimits, SteeringTurnsTowardTheTarget) {
  for (const TypeParam& robot : instances<TypeParam>()) {
    for (const float side : {-1.0F, 1.0F}) {
      std::vector<float> s(static_cast<std::size_t>(robot.state_size()), 0.0F);
      Steering steering;
      const Target target{{3.0F, side * 2.0F}, 0.8F, 0.1F};
      for (int i = 0; i < 10; ++i) {
        std::vector<float> u(2);
        robot.steer(StateView(s.data(), robot.state_size()), target, steering, ControlRef(u.data(), 2));
        s = step(robot, s, u, 0.1F);
      }
      EXPECT_GT(side * s[2], 0.02F);
      EXPECT_GT(s[0], 0.01F);
    }
  }
}

TEST(RobotLimitsChain, EachLimitIsExact) {
  ChainParameters p;
  p.trailers = 2;
  p.min_speed = -0.5F;
  const Truck truck(p);
  const auto inside = [&](std::vector<float> s) { return truck.within_limits(StateView(s.data(), 7)); };
  const auto beyond = [](float x) { return std::nextafter(x, x > 0 ? 1e9F : -1e9F); };
  EXPECT_TRUE(inside({0, 0, 0, p.max_speed, p.max_steering, 0, 0}));
  EXPECT_FALSE(inside({0, 0, 0, beyond(p.max_speed), 0, 0, 0}));
  EXPECT_TRUE(inside({0, 0, 0, p.min_speed, -p.max_steering, 0, 0}));
  EXPECT_FALSE(inside({0, 0, 0, beyond(p.min_speed), 0, 0, 0}));
  EXPECT_FALSE(inside({0, 0, 0, 0, beyond(p.max_steering), 0, 0}));
  EXPECT_FALSE(inside({0, 0, 0, 0, beyond(-p.max_steering), 0, 0}));
  EXPECT_TRUE(inside({0, 0, 0, 0, 0, p.max_hitch_angle, 0}));
  EXPECT_FALSE(inside({0, 0, 0, 0, 0, beyond(p.max_hitch_angle), 0}));
  EXPECT_FALSE(inside({0, 0, 0, 0, 0, -1.0F, -1.0F - p.max_hitch_angle - 1e-6F}));
}

TEST(RobotLimitsKinematicTruck, EachLimitIsExact) {
  KinematicTruckParameters p;
  p.trailers = 2;
  const KinematicTruck robot(p);
  const auto inside = [&](std::vector<float> s) { return robot.within_limits(StateView(s.data(), 5)); };
  EXPECT_TRUE(inside({0, 0, 0, p.max_hitch_angle, 0}));
  EXPECT_FALSE(inside({0, 0, 0, std::nextafter(p.max_hitch_angle, 2.0F), 0.5F}));
  EXPECT_FALSE(inside({0, 0, 0, -1.0F, -1.0F - p.max_hitch_angle - 1e-6F}));
  const std::vector<float> near = {0, 0, 0, p.max_hitch_angle - 1e-3F, 0};
  EXPECT_FALSE(robot.keeps_reserve(StateView(near.data(), 5)));
}

// A workstation's ranges lie within what the core accepts, so that no ROBOT.json is refused for a number that its help
// allows. The least speed is at most the largest one, which a workstation asks for, too.
TYPED_TEST(RobotLimits, ARobotIsSoundAtBothEndsOfEveryRange) {
  using Parameters = typename TypeParam::Parameters;
  Parameters::describe([]<class Number>(const ParameterField<Parameters, Number>& field) {
    if (*field.unit == '\0') return;  // no range
    EXPECT_LT(field.least, field.most) << field.name;
    for (const float end : {field.least, field.most}) {
      Parameters p = defaults_of<TypeParam>();
      p.*field.member = static_cast<Number>(end);
      if constexpr (requires { p.min_speed; }) p.max_speed = std::max(p.max_speed, p.min_speed);
      EXPECT_TRUE(TypeParam(p).sound()) << field.name << " " << end;
    }
  });
}

struct Spoiled {
  std::string name;
  std::function<void(ChainParameters&)> spoil;
};

// Of a robot that need not last.
template <RobotModel R>
Argument first_bad(const R& robot) {
  return detail::first_bad_of_robot(robot);
}

TEST(RobotSound, ChainRejectsEachBadParameter) {
  const std::vector<std::pair<const char*, float ChainParameters::*>> positives = {
      {"body_length", &ChainParameters::body_length},
      {"body_width", &ChainParameters::body_width},
      {"wheelbase", &ChainParameters::wheelbase},
      {"hitch_length", &ChainParameters::hitch_length},
      {"max_speed", &ChainParameters::max_speed},
      {"max_steering", &ChainParameters::max_steering},
      {"max_acceleration", &ChainParameters::max_acceleration},
      {"max_steering_rate", &ChainParameters::max_steering_rate},
      {"max_hitch_angle", &ChainParameters::max_hitch_angle}};
  for (const auto& [name, member] : positives) {
    for (const float bad : {0.0F, -1.0F, kNan, kInfinity}) {
      ChainParameters p;
      p.*member = bad;
      EXPECT_NE(first_bad(Snake(p)), Argument::none) << name << " " << bad;
      EXPECT_NE(first_bad(Truck(p)), Argument::none) << name << " " << bad;
      EXPECT_NE(first_bad(Car(p)), Argument::none) << name << " " << bad;
    }
  }
  const std::vector<Spoiled> others = {{"trailers", [](auto& p) { p.trailers = -1; }},
                                       {"trailers", [](auto& p) { p.trailers = kMaxTrailers + 1; }},
                                       {"trailers", [](auto& p) { p.trailers = 2147483647; }},
                                       {"min_speed", [](auto& p) { p.min_speed = 0.1F; }},
                                       {"min_speed", [](auto& p) { p.min_speed = kNan; }},
                                       {"min_speed", [](auto& p) { p.min_speed = -kInfinity; }},
                                       {"body_offset", [](auto& p) { p.body_offset = kNan; }},
                                       {"max_steering", [](auto& p) { p.max_steering = 1.5707964F; }},
                                       {"self_collision_gap", [](auto& p) { p.self_collision_gap = 0; }},
                                       {"max_hitch_angle", [](auto& p) { p.max_hitch_angle = 3.2F; }}};
  for (const auto& [name, spoil] : others) {
    ChainParameters p;
    spoil(p);
    EXPECT_NE(first_bad(Truck(p)), Argument::none) << name;
  }
}

TEST(RobotSound, KinematicTruckRejectsEachBadParameter) {
  for (const auto member : {&KinematicTruckParameters::body_length, &KinematicTruckParameters::body_width,
                            &KinematicTruckParameters::wheelbase, &KinematicTruckParameters::hitch_length,
                            &KinematicTruckParameters::max_speed, &KinematicTruckParameters::max_steering,
                            &KinematicTruckParameters::max_hitch_angle}) {
    for (const float bad : {0.0F, -1.0F, kNan, kInfinity}) {
      KinematicTruckParameters p;
      p.*member = bad;
      EXPECT_NE(first_bad(KinematicTruck(p)), Argument::none) << bad;
    }
  }
  const std::vector<std::function<void(KinematicTruckParameters&)>> others = {
      [](auto& p) { p.trailers = -1; },          [](auto& p) { p.trailers = kMaxTrailers + 1; },
      [](auto& p) { p.min_speed = 0.1F; },       [](auto& p) { p.min_speed = kNan; },
      [](auto& p) { p.body_offset = kNan; },     [](auto& p) { p.max_steering = 1.5000001F; },
      [](auto& p) { p.self_collision_gap = 0; }, [](auto& p) { p.max_hitch_angle = 3.2F; }};
  for (std::size_t i = 0; i < others.size(); ++i) {
    KinematicTruckParameters p;
    others[i](p);
    EXPECT_NE(first_bad(KinematicTruck(p)), Argument::none) << i;
  }
}

TEST(RobotSound, UnicycleRejectsEachBadParameter) {
  for (const auto member : {&UnicycleParameters::body_length, &UnicycleParameters::body_width,
                            &UnicycleParameters::max_speed, &UnicycleParameters::max_turn_rate}) {
    for (const float bad : {0.0F, -1.0F, kNan, kInfinity}) {
      UnicycleParameters p;
      p.*member = bad;
      EXPECT_NE(first_bad(Unicycle(p)), Argument::none) << bad;
    }
  }
  for (const float bad : {1.001F, kNan, -kInfinity}) {
    UnicycleParameters p;
    p.min_speed = bad;
    EXPECT_NE(first_bad(Unicycle(p)), Argument::none) << bad;
  }
}

TEST(RobotSound, Unicycle2RejectsEachBadParameter) {
  for (const auto member : {&Unicycle2Parameters::body_length, &Unicycle2Parameters::body_width,
                            &Unicycle2Parameters::max_speed, &Unicycle2Parameters::max_turn_rate,
                            &Unicycle2Parameters::max_acceleration, &Unicycle2Parameters::max_turn_acceleration}) {
    for (const float bad : {0.0F, -1.0F, kNan, kInfinity}) {
      Unicycle2Parameters p;
      p.*member = bad;
      EXPECT_NE(first_bad(Unicycle2(p)), Argument::none) << bad;
    }
  }
  for (const float bad : {0.5F, kNan, -kInfinity}) {
    Unicycle2Parameters p;
    p.min_speed = bad;
    EXPECT_NE(first_bad(Unicycle2(p)), Argument::none) << bad;
  }
}

TEST(RobotSound, DifferentialDriveRejectsEachBadParameter) {
  for (const auto member :
       {&DifferentialDriveParameters::body_length, &DifferentialDriveParameters::body_width,
        &DifferentialDriveParameters::wheel_radius, &DifferentialDriveParameters::track_width,
        &DifferentialDriveParameters::max_wheel_speed, &DifferentialDriveParameters::max_wheel_acceleration}) {
    for (const float bad : {0.0F, -1.0F, kNan, kInfinity}) {
      DifferentialDriveParameters p;
      p.*member = bad;
      EXPECT_NE(first_bad(DifferentialDrive(p)), Argument::none) << bad;
    }
  }
}

class RobotShape : public ::testing::TestWithParam<std::pair<const char*, std::vector<Vec2>>> {};

TEST_P(RobotShape, UnusableBodyIsRefusedByEveryModel) {
  const auto& vertices = GetParam().second;
  const Polygon body{vertices.data(), static_cast<int>(vertices.size())};
  ChainParameters p;
  p.trailers = 3;
  for (const int k : {0, 3}) {
    Snake snake(p);
    snake.set_body(k, body);
    EXPECT_EQ(detail::first_bad_of_robot(snake), Argument::robot_polygon);
  }
  Unicycle unicycle({});
  unicycle.set_body(0, body);
  EXPECT_EQ(detail::first_bad_of_robot(unicycle), Argument::robot_polygon);
}

INSTANTIATE_TEST_SUITE_P(
    Bodies, RobotShape,
    ::testing::Values(std::pair{"two", std::vector<Vec2>{{0, 0}, {1, 0}}},
                      std::pair{"nine", std::vector<Vec2>{{2, 0},
                                                          {1.5F, 1.3F},
                                                          {0.35F, 2},
                                                          {-1, 1.7F},
                                                          {-1.9F, 0.7F},
                                                          {-1.9F, -0.7F},
                                                          {-1, -1.7F},
                                                          {0.35F, -2},
                                                          {1.5F, -1.3F}}},
                      std::pair{"clockwise", std::vector<Vec2>{{0, 0}, {0, 1}, {1, 0}}},
                      std::pair{"flat", std::vector<Vec2>{{0, 0}, {1, 0}, {2, 0}}},
                      std::pair{"notch", std::vector<Vec2>{{0, 0}, {2, 0}, {0.5F, 0.5F}, {0, 2}}},
                      std::pair{"star", std::vector<Vec2>{{1, 0}, {1.8F, 2}, {0, 0.8F}, {2, 0.8F}, {0.2F, 2}}},
                      std::pair{"repeated", std::vector<Vec2>{{0, 0}, {1, 0}, {1, 0}, {1, 1}}},
                      std::pair{"nan", std::vector<Vec2>{{0, 0}, {1, 0}, {kNan, 1}}},
                      std::pair{"infinite", std::vector<Vec2>{{0, 0}, {1, 0}, {0, kInfinity}}},
                      std::pair{"huge", std::vector<Vec2>{{0, 0}, {101, 0}, {0, 1}}},
                      std::pair{"tiny", std::vector<Vec2>{{0, 0}, {1e-5F, 0}, {0, 1e-5F}}}),
    [](const auto& shape) { return std::string(shape.param.first); });

TEST(RobotShapes, MeasuresOfABox) {
  UnicycleParameters p;
  p.body_length = 0.8F;
  p.body_width = 0.5F;
  const Unicycle robot(p);
  EXPECT_FLOAT_EQ(detail::robot_length(robot), 0.8F);
  EXPECT_FLOAT_EQ(detail::inner_radius(robot.body(0), {}), 0.25F);
}

TEST(RobotShapes, InnerRadiusIsZeroWhenTheBodyLiesBesideItsAxle) {
  Unicycle robot({});
  const Vec2 ahead[] = {{0.5F, -0.2F}, {1, -0.2F}, {1, 0.2F}, {0.5F, 0.2F}};
  robot.set_body(0, {ahead, 4});
  EXPECT_EQ(detail::first_bad_of_robot(robot), Argument::none);
  EXPECT_EQ(detail::inner_radius(robot.body(0), {}), 0.0F);
}

}  // namespace
}  // namespace krait::test::robot_limits_test
