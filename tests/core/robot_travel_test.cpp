// travel() bounds how far any point of a body moves in a step: what the proof of free motion stands on.
#include <gtest/gtest.h>

#include <cmath>

#include "robot_oracle.hpp"

namespace krait::test {
namespace {

template <class R>
class RobotTravel : public ::testing::Test {};
TYPED_TEST_SUITE(RobotTravel, Models, ModelNames);

// Length of the path of every vertex of every body, in double precision by `parts` sub-steps.
template <class R>
std::vector<Numbers> path_lengths(const R& robot, const std::vector<float>& state, const std::vector<float>& u,
                                  double dt, int parts) {
  Numbers s = doubles(state);
  std::vector<Numbers> lengths(static_cast<std::size_t>(robot.body_count()));
  std::vector<std::vector<Numbers>> last;
  for (int i = 0; i <= parts; ++i) {
    const auto now = frames(robot, s);
    for (std::size_t k = 0; k < now.size(); ++k) {
      const auto at = vertices(robot.body(static_cast<int>(k)), now[k]);
      if (i == 0) {
        lengths[k].assign(at.size(), 0.0);
        last.push_back(at);
      }
      for (std::size_t j = 0; j < at.size(); ++j)
        lengths[k][j] += std::hypot(at[j][0] - last[k][j][0], at[j][1] - last[k][j][1]);
      last[k] = at;
    }
    s = rk4(robot, s, doubles(u), dt / parts);
  }
  return lengths;
}

TYPED_TEST(RobotTravel, BoundsThePathOfEveryVertex) {
  std::mt19937 random(1);
  double tightest = 0;
  for (const TypeParam& robot : instances<TypeParam>()) {
    for (const float dt : {0.05F, 0.1F, 0.4F}) {
      for (int i = 0; i < 120; ++i) {
        const auto s = random_state(robot, random);
        const auto u = random_control(robot, s, dt, random);
        const auto lengths = path_lengths(robot, s, u, wide(dt), 60);
        for (std::size_t k = 0; k < lengths.size(); ++k) {
          const double bound = wide(
              robot.travel(StateView(s.data(), robot.state_size()), ControlView(u.data(), 2), dt, static_cast<int>(k)));
          for (const double length : lengths[k]) {
            ASSERT_LE(length, bound * (1 + 1e-6) + 1e-7) << "body " << k << " dt " << dt;
            if (bound > 0.01) tightest = std::max(tightest, length / bound);
          }
        }
      }
    }
  }
  EXPECT_GT(tightest, 0.5);  // a bound that is always far too large would pass as well
}

// The slip of the paper's robot adds to the speed of a tail that is curled back: faster than the front wheel.
TEST(RobotTravelSnake, BoundsTheTailOfACurledSnake) {
  ChainParameters p;
  p.trailers = kMaxTrailers;
  Snake snake(p);
  const Vec2 small[] = {{-1e-3F, -1e-3F}, {1e-3F, -1e-3F}, {0, 1e-3F}};
  snake.set_body(kMaxTrailers, {small, 3});
  std::vector<float> s(30, 0.0F);
  s[3] = p.max_speed;
  s[4] = p.max_steering;
  for (std::size_t i = 5; i < s.size(); ++i) s[i] = s[i == 5 ? 2 : i - 1] + kPi / kMaxTrailers;
  const std::vector<float> u = {0, 0};
  const double length = path_lengths(snake, s, u, 0.02, 20).back()[0];
  EXPECT_GT(length, 1.1 * 0.02 * wide(p.max_speed));
  EXPECT_LE(length, wide(snake.travel(StateView(s.data(), 30), ControlView(u.data(), 2), 0.02F, kMaxTrailers)));
}

TYPED_TEST(RobotTravel, StandingStillIsZero) {
  for (const TypeParam& robot : instances<TypeParam>()) {
    const std::vector<float> s(static_cast<std::size_t>(robot.state_size()), 0.0F), u(2, 0.0F);
    for (int k = 0; k < robot.body_count(); ++k) {
      EXPECT_EQ(robot.travel(StateView(s.data(), robot.state_size()), ControlView(u.data(), 2), 0.1F, k), 0.0F);
    }
  }
}

TYPED_TEST(RobotTravel, BoundsBodiesThatTheUserShaped) {
  std::mt19937 random(2);
  const Vec2 far[] = {{1, -0.3F}, {2, 0}, {1, 0.3F}};
  for (TypeParam robot : instances<TypeParam>()) {
    robot.set_body(robot.body_count() - 1, {far, 3});
    for (int i = 0; i < 100; ++i) {
      const auto s = random_state(robot, random);
      const auto u = random_control(robot, s, 0.1F, random);
      const int k = robot.body_count() - 1;
      const auto lengths = path_lengths(robot, s, u, wide(0.1F), 40);
      const double bound =
          wide(robot.travel(StateView(s.data(), robot.state_size()), ControlView(u.data(), 2), 0.1F, k));
      for (const double length : lengths[static_cast<std::size_t>(k)]) ASSERT_LE(length, bound * (1 + 1e-6) + 1e-7);
    }
  }
}

}  // namespace
}  // namespace krait::test
