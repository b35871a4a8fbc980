// SPDX-License-Identifier: Apache-2.0
// A step that a chain calls within its limits, or a collision check free, keeps them all the way, by the same motion in
// small steps of double precision.
#include "base/random.hpp"
#include "collision/motion_check.hpp"
#include "in_own_memory.hpp"
#include "robot_oracle.hpp"
#include "scene_builder.hpp"

namespace krait::test::robot_keeps_limits_test {
namespace {

constexpr float kDt = 0.1F;

// A chain in motion whose hitch angles crowd at their limit.
template <class R>
std::vector<float> bent_state(const R& robot, detail::Random& random) {
  const ChainParameters& p = robot.parameters();
  std::vector<float> s(static_cast<std::size_t>(robot.state_size()), 0.0F);
  s[2] = 6.0F * random.unit() - 3.0F;
  s[3] = p.max_speed * random.unit();
  s[4] = p.max_steering * (2.0F * random.unit() - 1.0F);
  float ahead = s[2];
  for (std::size_t i = 5; i < s.size(); ++i) {
    const float size = p.max_hitch_angle * (random.unit() < 0.5F ? random.unit() : 1.0F - 0.05F * random.unit());
    s[i] = ahead + (random.unit() < 0.5F ? size : -size);
    ahead = s[i];
  }
  return s;
}

double largest_hitch(const Numbers& s) {
  double largest = 0;
  for (std::size_t i = 5; i < s.size(); ++i) {
    largest = std::max(largest, std::abs((i == 5 ? s[2] : s[i - 1]) - s[i]));
  }
  return largest;
}

struct Tally {
  int kept = 0;
  int broken_between = 0;  // inside at both ends, outside on the way
};

// Of the steps that `is_kept` none may pass the limit by more than `error`.
template <class R, class IsKept>
Tally try_steps(const R& robot, float dt, int count, IsKept is_kept, double error) {
  const double limit = wide(robot.parameters().max_hitch_angle);
  detail::Random random(11);
  Tally tally;
  for (int n = 0; n < count; ++n) {
    const std::vector<float> s = bent_state(robot, random);
    const std::vector<float> u = {robot.parameters().max_acceleration * (2.0F * random.unit() - 1.0F),
                                  robot.parameters().max_steering_rate * (2.0F * random.unit() - 1.0F)};
    const std::vector<float> next = step(robot, s, u, dt);
    const StateView before(s.data(), robot.state_size()), after(next.data(), robot.state_size());
    if (!robot.within_limits(before) || !robot.within_limits(after)) continue;
    Numbers fine(s.begin(), s.end());
    double largest = 0;
    for (int i = 0; i < 64; ++i) {
      fine = rk4(robot, fine, {wide(u[0]), wide(u[1])}, wide(dt) / 64);
      largest = std::max(largest, largest_hitch(fine));
    }
    tally.broken_between += largest > limit + 1e-4 ? 1 : 0;
    if (!is_kept(s, u, next)) continue;
    ++tally.kept;
    EXPECT_LE(largest, limit + error) << "step " << n;
  }
  return tally;
}

template <class R>
Tally try_steps(const R& robot, float dt, int count) {
  const auto proven = [&](const auto& s, const auto& u, const auto& next) {
    return bounds_of(robot, s, u, dt, next).limits_kept;
  };
  return try_steps(robot, dt, count, proven, 1e-5);
}

ChainParameters train(int trailers) {
  ChainParameters p;
  p.trailers = trailers;
  return p;
}

TEST(RobotKeepsLimits, NoHitchPassesItsLimitInAStepThatIsCalledKept) {
  const auto snake = try_steps(Snake(train(3)), kDt, 20000);
  EXPECT_GT(snake.kept, 100);
  EXPECT_GT(snake.broken_between, 0);  // else the states do not try it
  const auto truck = try_steps(Truck(train(3)), kDt, 20000);
  EXPECT_GT(truck.kept, 100);
}

// Also where the whole step was not proven to, but its parts were.
TEST(RobotKeepsLimits, NoHitchPassesItsLimitInAStepThatIsFree) {
  const Snake snake(train(3));
  Room room;
  room.bounds = {-10, -10, 10, 10};
  const OpenScene open(room);
  InOwnMemory<detail::MotionCheck> check;
  check.assign(snake, open.scene, 0.0F, 16, true);
  int by_parts = 0;
  const auto is_free = [&](const auto& s, const auto& u, const auto& next) {
    if (!check.free(s.data())) return false;
    const bool whole = check.keeps_limits(s.data(), u.data(), kDt, next.data());
    const bool free = check.step_free(s.data(), u.data(), kDt, next.data());
    by_parts += free && !whole ? 1 : 0;
    return free;
  };
  const auto tally = try_steps(snake, kDt, 40000, is_free, 1e-3);
  EXPECT_GT(tally.kept, 100);
  EXPECT_GT(tally.broken_between, 0);
  EXPECT_GT(by_parts, 10);
}

TEST(RobotKeepsLimits, ShortStepsAreKeptUpToTheLimit) {
  const auto snake = try_steps(Snake(train(1)), kDt / 16, 2000);
  EXPECT_GT(snake.kept, 1000);
}

TEST(RobotKeepsLimits, AStraightTrainKeepsThem) {
  const Truck truck(train(5));
  std::vector<float> s(10);
  truck.rest({1, 2}, 0.5F, nullptr, s.data());
  s[3] = 2.0F;
  const std::vector<float> u = {0, 0};
  EXPECT_TRUE(bounds_of(truck, s, u, kDt, step(truck, s, u, kDt)).limits_kept);
}

// Those of a body without trailers are.
TEST(RobotKeepsLimits, ARobotWhoseLimitsAreConvexKeepsThem) {
  std::mt19937 random(3);
  AllRobots<Each>::call([&]<class R>() {
    if constexpr (std::derived_from<R, PlanarBody>) {
      for (const R& robot : instances<R>()) {
        for (int i = 0; i < 100; ++i) {
          const std::vector<float> s = random_state(robot, random), u = random_control(robot, s, kDt, random);
          EXPECT_TRUE(bounds_of(robot, s, u, kDt, step(robot, s, u, kDt)).limits_kept) << ModelNames::GetName<R>(0);
        }
      }
    }
  });
}

}  // namespace
}  // namespace krait::test::robot_keeps_limits_test
