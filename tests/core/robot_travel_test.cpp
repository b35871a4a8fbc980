// SPDX-License-Identifier: Apache-2.0
// travel() and quick_bound() bound every motion of a step: what the proof of free motion stands on. For chains,
// lib/robot/CHAIN.md has the lemmas that are named here; chain_lemmas_test.cpp holds one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "krait/robots/detail/defaults.hpp"
#include "robot/tracking.hpp"
#include "robot_oracle.hpp"

namespace krait::test::robot_travel_test {
namespace {

template <class R>
class RobotTravel : public ::testing::Test {};
TYPED_TEST_SUITE(RobotTravel, Models, ModelNames);

// A step's true motion: by body and vertex, where it is after each of `parts` sub-steps in double precision. The last
// vertex is the body's origin.
using Places = std::vector<std::vector<Numbers>>;
template <class R>
std::vector<Places> motion(const R& robot, const std::vector<float>& state, const std::vector<float>& u, double dt,
                           int parts) {
  Numbers s = doubles(state);
  std::vector<Places> result;
  for (int i = 0; i <= parts; ++i) {
    const auto now = frames(robot, s);
    Places places;
    for (std::size_t k = 0; k < now.size(); ++k) {
      places.push_back(vertices(robot.body(static_cast<int>(k)), now[k]));
      places.back().push_back({now[k].x, now[k].y});
    }
    result.push_back(places);
    s = rk4(robot, s, doubles(u), dt / parts);
  }
  return result;
}

double apart(const Numbers& a, const Numbers& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

double path_length(const std::vector<Places>& motion, std::size_t body, std::size_t vertex) {
  double length = 0;
  for (std::size_t i = 1; i < motion.size(); ++i) length += apart(motion[i][body][vertex], motion[i - 1][body][vertex]);
  return length;
}

// How far the vertex was at most from the straight line, at uniform speed, between its places at the ends.
double deviation(const std::vector<Places>& motion, std::size_t body, std::size_t vertex) {
  const Numbers &from = motion.front()[body][vertex], &to = motion.back()[body][vertex];
  double most = 0;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(motion.size() - 1);
    most = std::max(most,
                    apart(motion[i][body][vertex], {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])}));
  }
  return most;
}

// How tight bounds are: the motion over the bound, of bounds that are worth a look.
struct Ratios {
  void add(double motion, double bound, double least) {
    if (bound > least) values.push_back(motion / bound);
  }
  double median() {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values.at(values.size() / 2);
  }
  double largest() const { return *std::max_element(values.begin(), values.end()); }

  std::vector<double> values;
};

template <class R>
QuickBound quick_bound_of(const R& robot, const std::vector<float>& s, const std::vector<float>& u, float dt,
                          const std::vector<float>& next) {
  return detail::quick_bound(robot, StateView(s.data(), robot.state_size()), ControlView(u.data(), 2), dt,
                             StateView(next.data(), robot.state_size()));
}

// Checks the bounds of a step on every vertex of every body (lemmas 1 to 9); those of all bodies alike, where there are
// any (lemmas 10 to 12).
template <class R>
void expect_bounded(const R& robot, const std::vector<float>& s, const std::vector<float>& u, float dt, Ratios& paths,
                    Ratios& bends) {
  const auto next = step(robot, s, u, dt);
  const Bounds bounds = bounds_of(robot, s, u, dt, next);
  // The hitch angles' bounds start from both ends' being inside the limits.
  if (!robot.within_limits(StateView(next.data(), robot.state_size()))) return;
  const auto places = motion(robot, s, u, wide(dt), 40);
  const QuickBound quick = quick_bound_of(robot, s, u, dt, next);
  EXPECT_LE(quick.limits_kept, bounds.limits_kept);
  for (std::size_t k = 0; k < places[0].size(); ++k) {
    const Travel& travel = bounds.bodies[k];
    for (std::size_t v = 0; v < places[0][k].size(); ++v) {
      const double radius = apart(places[0][k][v], places[0][k].back());
      const double path = wide(travel.path) + radius * wide(travel.turn);
      const double bend = wide(travel.bend) + radius * wide(travel.twist);
      const double length = path_length(places, k, v), strayed = deviation(places, k, v);
      ASSERT_LE(length, path * (1 + 1e-5) + 1e-7) << "body " << k << " dt " << dt;
      ASSERT_LE(strayed, bend * (1 + 1e-5) + 1e-7) << "body " << k << " dt " << dt;
      paths.add(length, path, 0.01);
      bends.add(strayed, bend, 1e-4);
      if (!quick.limits_kept) continue;
      ASSERT_LE(length, (wide(quick.most.path) + radius * wide(quick.most.turn)) * (1 + 1e-5) + 1e-7) << "body " << k;
      ASSERT_LE(strayed, (wide(quick.most.bend) + radius * wide(quick.most.twist)) * (1 + 1e-5) + 1e-7) << "body " << k;
    }
  }
}

TYPED_TEST(RobotTravel, BoundsThePathAndTheBendOfEveryVertex) {
  std::mt19937 random(1);
  for (const float dt : {0.025F, 0.05F, 0.1F, 0.4F}) {
    Ratios paths, bends;
    for (const TypeParam& robot : instances<TypeParam>()) {
      for (int i = 0; i < 120; ++i) {
        const auto s = random_state(robot, random);
        const auto u = random_control(robot, s, dt, random);
        expect_bounded(robot, s, u, dt, paths, bends);
        if (this->HasFatalFailure()) return;
      }
    }
    // Bounds that are always far too large would pass as well.
    EXPECT_GT(paths.largest(), 0.9) << dt;
    EXPECT_GT(bends.largest(), 0.7) << dt;
  }
}

// What the planner drives: steered steps, mostly straight.
TYPED_TEST(RobotTravel, BoundsAreNotFarTooLargeUnderSteering) {
  std::mt19937 random(3);
  Ratios paths, bends;
  for (const TypeParam& robot : instances<TypeParam>()) {
    std::vector<float> s(static_cast<std::size_t>(robot.state_size()), 0.0F);
    Steering steering;
    Target target{{20, 5}, 0.9F, 0.1F};
    for (int i = 0; i < 200; ++i) {
      if (i % 25 == 24) target.point = {uniform_float(random, -20, 20), uniform_float(random, -20, 20)};
      std::vector<float> u(2);
      robot.steer(StateView(s.data(), robot.state_size()), target, steering, ControlRef(u.data(), 2));
      expect_bounded(robot, s, u, 0.1F, paths, bends);
      if (this->HasFatalFailure()) return;
      s = step(robot, s, u, 0.1F);
    }
  }
  EXPECT_GT(paths.median(), 0.5);
  EXPECT_GT(bends.median(), 0.1);
}

// Lemma 4: the slip of the paper's robot adds to the speed of a tail that is curled back: faster than the front wheel.
TEST(RobotTravelSnake, BoundsTheTailOfACurledSnake) {
  ChainParameters p;
  p.trailers = kMaxTrailers;
  Snake snake(p);
  std::vector<float> s(30, 0.0F);
  s[3] = p.max_speed;
  s[4] = p.max_steering;
  for (std::size_t i = 5; i < s.size(); ++i) s[i] = s[i == 5 ? 2 : i - 1] + kPi / kMaxTrailers;
  const std::vector<float> u = {0, 0};
  const auto places = motion(snake, s, u, 0.02, 20);
  const double length = path_length(places, kMaxTrailers, places[0][kMaxTrailers].size() - 1);
  EXPECT_GT(length, 1.1 * 0.02 * wide(p.max_speed));
  const auto next = step(snake, s, u, 0.02F);
  EXPECT_LE(length, wide(bounds_of(snake, s, u, 0.02F, next).bodies.back().path));
  const QuickBound quick = quick_bound_of(snake, s, u, 0.02F, next);
  EXPECT_TRUE(quick.limits_kept);
  EXPECT_LE(length, wide(quick.most.path));
}

TYPED_TEST(RobotTravel, StandingStillIsZero) {
  for (const TypeParam& robot : instances<TypeParam>()) {
    const std::vector<float> s(static_cast<std::size_t>(robot.state_size()), 0.0F), u(2, 0.0F);
    const Bounds bounds = bounds_of(robot, s, u, 0.1F, s);
    EXPECT_TRUE(bounds.limits_kept);
    for (const Travel& travel : bounds.bodies) {
      EXPECT_EQ(travel.path, 0.0F);
      EXPECT_EQ(travel.turn, 0.0F);
      EXPECT_EQ(travel.bend, 0.0F);
      EXPECT_EQ(travel.twist, 0.0F);
    }
  }
}

TYPED_TEST(RobotTravel, BoundsBodiesThatTheUserShaped) {
  std::mt19937 random(2);
  const Vec2 far[] = {{1, -0.3F}, {2, 0}, {1, 0.3F}};
  Ratios paths, bends;
  for (TypeParam robot : instances<TypeParam>()) {
    robot.set_body(robot.body_count() - 1, {far, 3});
    for (int i = 0; i < 100; ++i) {
      const auto s = random_state(robot, random);
      expect_bounded(robot, s, random_control(robot, s, 0.1F, random), 0.1F, paths, bends);
      if (this->HasFatalFailure()) return;
    }
  }
}

template <class R>
class RobotSeparation : public ::testing::Test {};
using Chains = ::testing::Types<Snake, Truck>;
TYPED_TEST_SUITE(RobotSeparation, Chains, ModelNames);

// The largest of the hitch angles from trailer `first` on, at any time of a step's true motion.
double largest_hitch(const Chain& chain, std::size_t first, const std::vector<Numbers>& states) {
  double most = 0;
  for (const Numbers& s : states) {
    for (std::size_t i = 4 + first; i < 5 + static_cast<std::size_t>(chain.parameters().trailers); ++i) {
      most = std::max(most, std::abs(s[i == 5 ? 2 : i - 1] - s[i]));
    }
  }
  return most;
}

// Lemmas 5 and 10.
TYPED_TEST(RobotSeparation, NoStepIsProvenBetweenWhoseStatesAHitchFolds) {
  ChainParameters p;
  p.trailers = 5;
  p.max_hitch_angle = 0.9F;
  const TypeParam robot(p);
  std::mt19937 random(6);
  int folding = 0, folding_further_back = 0, proven = 0;
  for (int i = 0; i < 20'000; ++i) {
    auto s = random_state(robot, random);
    for (std::size_t k = 5; k < s.size(); ++k) s[k] = s[k == 5 ? 2 : k - 1] + uniform_float(random, -0.9, 0.9);
    const auto u = random_control(robot, s, 0.1F, random);
    const auto next = step(robot, s, u, 0.1F);
    if (!robot.within_limits(StateView(s.data(), 10)) || !robot.within_limits(StateView(next.data(), 10))) continue;
    std::vector<Numbers> states{doubles(s)};
    for (int part = 0; part < 20; ++part) states.push_back(rk4(robot, states.back(), doubles(u), 0.1 / 20));
    const bool by_body = bounds_of(robot, s, u, 0.1F, next).limits_kept;
    const bool by_all = quick_bound_of(robot, s, u, 0.1F, next).limits_kept;
    proven += by_all ? 1 : 0;
    if (largest_hitch(robot, 1, states) <= wide(p.max_hitch_angle)) continue;
    ++folding;
    folding_further_back += largest_hitch(robot, 2, states) > wide(p.max_hitch_angle) ? 1 : 0;
    ASSERT_FALSE(by_body);
    ASSERT_FALSE(by_all);
  }
  EXPECT_GT(folding, 5);
  EXPECT_GT(folding_further_back, 3);
  EXPECT_GT(proven, 100);
}

// A chain that winds a little, some of them more.
std::vector<float> winding_state(const Chain& chain, std::mt19937& random) {
  auto s = random_state(chain, random);
  const double wind = uniform(random, 0, 0.3), curl = uniform(random, -0.2, 0.2);
  for (std::size_t i = 5; i < s.size(); ++i) {
    s[i] = (i == 5 ? s[2] : s[i - 1]) + uniform_float(random, curl - wind, curl + wind);
  }
  return s;
}

TYPED_TEST(RobotSeparation, Lemma13_IsNeverMoreThanTheLeastDistanceOnTheWay) {
  std::mt19937 random(4);
  int told = 0, tight = 0;
  for (TypeParam robot : instances<TypeParam>()) {
    for (const int gap : {2, 3, 1}) {
      ChainParameters p = robot.parameters();
      p.self_collision_gap = gap;
      robot = TypeParam(p);
      for (int i = 0; i < 200; ++i) {
        const float dt = i % 2 == 0 ? 0.1F : 0.4F;
        const auto s = winding_state(robot, random);
        const auto u = random_control(robot, s, dt, random);
        const auto next = step(robot, s, u, dt);
        if (!robot.within_limits(StateView(s.data(), robot.state_size()))) continue;
        if (!robot.within_limits(StateView(next.data(), robot.state_size()))) continue;
        const QuickBound quick = quick_bound_of(robot, s, u, dt, next);
        const double bound = quick.limits_kept ? wide(quick.separation) : 0;
        double least = std::numeric_limits<double>::infinity();
        for (const Places& at : motion(robot, s, u, wide(dt), 20)) {
          for (std::size_t a = 0; a < at.size(); ++a) {
            for (std::size_t b = a + static_cast<std::size_t>(gap); b < at.size(); ++b) {
              least = std::min(least, apart(at[a].back(), at[b].back()));
            }
          }
        }
        ASSERT_LE(bound, least * (1 + 1e-6)) << "trailers " << p.trailers << " gap " << gap << " dt " << dt;
        told += bound > 0 ? 1 : 0;
        tight += bound > 0.8 * least ? 1 : 0;
      }
    }
  }
  EXPECT_GT(told, 500);
  EXPECT_GT(tight, 200);
}

TEST(RobotSeparationStraight, IsTheWholeChainsLength) {
  ChainParameters p;
  p.trailers = 5;
  const Snake snake(p);
  std::vector<float> s(10, 0.25F);
  s[3] = s[4] = 0;
  EXPECT_FLOAT_EQ(quick_bound_of(snake, s, {0, 0}, 0.1F, s).separation, 2 * p.hitch_length);
}

}  // namespace
}  // namespace krait::test::robot_travel_test
