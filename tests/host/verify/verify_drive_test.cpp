// SPDX-License-Identifier: Apache-2.0
// The motion that the verifier drives, against classic Runge-Kutta of this file in steps 64 times as fine and against
// closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "host/verify/bodies.hpp"
#include "host/verify/drive.hpp"
#include "plans.hpp"

namespace krait::host::testing {
namespace {

// The state after `time` seconds in `count` steps of the classic method of fourth order.
Row classic(const RobotSpec& spec, Row s, const Row& u, double time, std::size_t count) {
  const double h = time / static_cast<double>(count);
  const auto moved = [&](const Row& rate, double by) {
    Row to = s;
    for (std::size_t i = 0; i < s.size(); ++i) to[i] += by * rate[i];
    return to;
  };
  for (std::size_t step = 0; step < count; ++step) {
    const Row k1 = rates(spec, s, u);
    const Row k2 = rates(spec, moved(k1, h / 2), u);
    const Row k3 = rates(spec, moved(k2, h / 2), u);
    const Row k4 = rates(spec, moved(k3, h), u);
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return s;
}

double difference(const Row& a, const Row& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

struct DriveCase {
  std::string name;
  RobotSpec robot;
  double speed;  // m/s
  double dt;     // s
  double time;   // s, how long it drives
};

RobotSpec small(const std::string& model, int links) {
  RobotSpec spec = robot(model, links);
  spec.parameters["hitch_length"] = 0.05;
  spec.parameters["wheelbase"] = 0.1;
  spec.parameters["self_collision_gap"] = 1;  // bodies that follow each other are near each other, and must not meet
  spec.bodies.assign(spec.bodies.size(), rectangle(-0.02, -0.02, 0.02, 0.02));
  return spec;
}

std::vector<DriveCase> drive_cases() {
  std::vector<DriveCase> all;
  for (const double dt : {0.001, 0.1, 1.0}) {
    const std::string millis = std::to_string(std::lround(dt * 1000)) + "ms";
    for (const RobotSpec& spec : every_robot(15)) {
      all.push_back({spec.model + std::to_string(spec.links) + "_" + millis, spec, 2, dt, 20 * dt});
    }
    for (const char* model : {"snake", "truck"}) {
      all.push_back({model + std::string("_hitch_50mm_") + millis, small(model, 3), 5, dt, 3 * dt});
    }
  }
  all.push_back({"truck_backing", robot("truck", 2), -1, 0.1, 3});
  all.push_back({"kinematic_truck_backing", robot("kinematic_truck", 2), -1, 0.1, 3});
  return all;
}

class EveryDrive : public ::testing::TestWithParam<DriveCase> {
 protected:
  // A state at speed, bent a little.
  State start() const {
    const DriveCase& c = GetParam();
    Row state = Dynamics(c.robot).at_rest({3, 4}, 0.3, {});
    if (c.robot.model == "diff_drive") state[3] = state[4] = c.speed / 0.1;
    if (has_front_axle(c.robot.model)) state[3] = c.speed;
    for (std::size_t i = state.size() - static_cast<std::size_t>(c.robot.links); i < state.size(); ++i)
      state[i] += 0.1 * std::sin(static_cast<double>(i));
    return state;
  }

  // Controls that swing to and fro.
  Control control(double time) const {
    const DriveCase& c = GetParam();
    const double swing = std::cos(2 * time);
    if (c.robot.model == "unicycle") return {c.speed, 2 * swing};
    if (c.robot.model == "kinematic_truck") return {c.speed, 0.4 * swing};
    if (c.robot.model == "diff_drive") return {-8 * swing, 8 * swing};
    return {0, c.dt > 0.5 ? 0.2 * swing : swing};
  }

  // Visits each leg with the state that it begins with, its control and its number of sub-steps.
  template <typename Visit>
  void drive(const Visit& visit) const {
    const DriveCase& c = GetParam();
    const Dynamics dynamics(c.robot);
    const Drive drive(c.robot, dynamics);
    State state = start();
    for (double time = 0; time < c.time - c.dt / 2; time += c.dt) {
      const std::optional<Leg> leg = drive.leg(state, control(time), c.dt);
      ASSERT_TRUE(leg) << time;
      visit(*leg, control(time), leg->states.size() - 1);
      state = leg->states.back();
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Robots, EveryDrive, ::testing::ValuesIn(drive_cases()),
                         [](const auto& chosen) { return chosen.param.name; });

TEST_P(EveryDrive, EndsWhereAFinerIntegrationEnds) {
  const DriveCase& c = GetParam();
  Row truth = start();
  Row end;
  drive([&](const Leg& leg, const Control& u, std::size_t count) {
    truth = classic(c.robot, truth, u, c.dt, 64 * count);
    end = leg.states.back();
    EXPECT_LT(difference(classic(c.robot, leg.states.front(), u, c.dt, 64 * count), end), 1e-10);
  });
  EXPECT_LT(difference(truth, end), 1e-8);
}

TEST_P(EveryDrive, StraysFromItsHullsByNoMoreThanItSays) {
  const DriveCase& c = GetParam();
  const Dynamics dynamics(c.robot);
  const std::vector<double> radii = radii_of(c.robot);
  drive([&](const Leg& leg, const Control& u, std::size_t count) {
    ASSERT_LE(leg.stray, 2e-5);
    const std::size_t stride = 1 + count / 64;
    for (std::size_t i = 0; i < count; i += stride) {
      const double half = c.dt / static_cast<double>(2 * count);
      const auto middle = dynamics.frames(classic(c.robot, leg.states[i], u, half, 8));
      for (std::size_t body = 0; body < c.robot.bodies.size(); ++body) {
        for (const Point& corner : c.robot.bodies[body]) {
          const Point a = leg.poses[i][body].place(corner);
          const Point b = leg.poses[i + 1][body].place(corner);
          const Point m = middle[body].place(corner);
          EXPECT_LE(std::hypot(m.x - (a.x + b.x) / 2, m.y - (a.y + b.y) / 2), leg.stray + 1e-12);
        }
      }
      for_each_pair(dynamics, [&](std::size_t first, std::size_t second) {
        if (gap(middle[first], middle[second]) > radii[first] + radii[second]) return;
        for (const Point& corner : c.robot.bodies[second]) {
          const auto seen = [&](const Pose& pose) { return pose[first].inverse(pose[second].place(corner)); };
          const Point a = seen(leg.poses[i]);
          const Point b = seen(leg.poses[i + 1]);
          EXPECT_LE(distance(seen(middle), {(a.x + b.x) / 2, (a.y + b.y) / 2}), leg.stray + 1e-12);
        }
      });
    }
  });
}

TEST(Drive, EndsACircleOfAHundredThousandStepsWhereItMust) {
  const RobotSpec spec = robot("unicycle");
  const Dynamics dynamics(spec);
  const Drive drive(spec, dynamics);
  State state{0, 0, 0};
  for (int i = 0; i < 100'000; ++i) state = drive.leg(state, {2, 0.8}, 0.1)->states.back();
  const double turned = 0.8 * 0.1 * 100'000;
  EXPECT_NEAR(state[2], turned, 1e-6);
  EXPECT_NEAR(state[0], 2.5 * std::sin(turned), 3e-6);
  EXPECT_NEAR(state[1], 2.5 * (1 - std::cos(turned)), 3e-6);
}

TEST(Drive, OfATrailerOnACircleFindsItsSteadyAngle) {
  const RobotSpec spec = small("truck", 1);
  const Dynamics dynamics(spec);
  const Drive drive(spec, dynamics);
  State state{0, 0, 0, 5, 0.3, 0.2};
  for (int i = 0; i < 5; ++i) state = drive.leg(state, {0, 0}, 1)->states.back();
  const double turn_rate = 5 * std::sin(0.3) / 0.1;
  const double speed = 5 * std::cos(0.3);
  EXPECT_NEAR(std::sin(state[2] - state[5]), turn_rate * 0.05 / speed, 1e-9);
}

TEST(Drive, FarAwayAndTurnedManyTimesIsFollowedAsWell) {
  const RobotSpec spec = small("truck", 2);
  const Dynamics dynamics(spec);
  const Drive drive(spec, dynamics);
  const auto end = [&](double offset, double turns) {
    const double turned = 2 * std::numbers::pi * turns;
    const State from{offset, offset, 0.4 + turned, 5, 0.3, 0.2 + turned, 0.1 + turned};
    return drive.leg(from, {0, -0.2}, 1)->states.back();
  };
  const State near = end(0, 0);
  const State far = end(4000, 500);
  EXPECT_NEAR(far[0] - 4000, near[0], 1e-8);
  EXPECT_NEAR(far[1] - 4000, near[1], 1e-8);
}

TEST(Drive, ThatIsTooFastToFollowIsNone) {
  const RobotSpec spec = robot("unicycle");
  const Dynamics dynamics(spec);
  const Drive drive(spec, dynamics);
  EXPECT_FALSE(drive.leg({0, 0, 0}, {0, 1e5}, 1));
  EXPECT_FALSE(drive.leg({0, 0, 0}, {1e300, 1e300}, 1));
  EXPECT_TRUE(drive.leg({0, 0, 0}, {0, 100}, 1));
}

}  // namespace
}  // namespace krait::host::testing
