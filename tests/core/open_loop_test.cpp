// What a robot does under a plan's controls alone, against double precision, and what becomes of plans that miss.
#include "krait/motion/open_loop.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planner_fixture.hpp"
#include "robot_oracle.hpp"

namespace krait::test {
namespace {

double distance(const Numbers& state, double x, double y) { return std::hypot(state[0] - x, state[1] - y); }

template <class R>
class OpenLoopOf : public ::testing::Test {};
TYPED_TEST_SUITE(OpenLoopOf, Models, ModelNames);

// Thirteen minutes of driving: far better than the states that are rounded at every step.
TYPED_TEST(OpenLoopOf, StaysWithTheTrueMotionWhereStatesDrift) {
  double worst = 0, states_worst = 0;
  for (const TypeParam& robot : instances<TypeParam>()) {
    std::mt19937 random(1);
    std::vector<float> s(static_cast<std::size_t>(robot.state_size()), 0.0F), u(2);
    OpenLoop<TypeParam> open;
    open.begin(robot, s.data());
    Numbers truth = doubles(s);
    Steering steering;
    Target target{{50, 50}, 0.9F, 0.05F};
    for (int i = 0; i < 8000; ++i) {
      if (i % 40 == 39) target.point = {uniform_float(random, 0, 100), uniform_float(random, 0, 100)};
      robot.steer(StateView(s.data(), robot.state_size()), target, steering, ControlRef(u.data(), 2));
      open.step(u.data(), target.dt);
      for (int part = 0; part < 4; ++part) truth = rk4(robot, truth, doubles(u), wide(target.dt) / 4);
      s = step(robot, s, u, target.dt);
    }
    worst = std::max(worst, distance(truth, wide(open.position().x), wide(open.position().y)));
    states_worst = std::max(states_worst, distance(truth, wide(s[0]), wide(s[1])));
  }
  EXPECT_LT(worst, 0.005);
  EXPECT_GT(states_worst, 2 * worst);
}

TEST(OpenLoopPlan, ThatWouldMissIsNotGivenOut) {
  UnicycleParameters p;
  p.body_length = 0.5F;
  p.body_width = 0.4F;
  p.max_turn_rate = 2.0F;
  const float start[] = {2, 6, 0};
  int solved = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    Bench<Unicycle> bench(two_rooms(), Unicycle(p));
    bench.parameters.dt = 1.0F;  // too long for so fast a turn
    bench.limits.iterations = 3000;
    ASSERT_TRUE(bench.init().ok());
    int in_goal = 0;
    const Goal goal = Goal::named(0);
    bench.planner.start({start, goal, seed});
    bench.planner.advance(1'000'000, [&](const float*, const float* to) {
      in_goal += goal.contains(bench.open.scene, {to[0], to[1]}, bench.parameters.goal_margin) ? 1 : 0;
    });
    if (bench.planner.status() != Status::solved) continue;
    ++solved;
    refused += in_goal - 1;
    const Path path(bench.planner.plan());
    Numbers state = doubles(path.states.front());
    for (const auto& u : path.controls) {
      for (int part = 0; part < 32; ++part) state = rk4(bench.robot, state, doubles(u), 1.0 / 32);
    }
    ASSERT_LE(distance(state, wide(path.states.back()[0]), wide(path.states.back()[1])), 0.05) << seed;
    ASSERT_TRUE(goal.contains(bench.open.scene, {static_cast<float>(state[0]), static_cast<float>(state[1])}, 0.0F));
  }
  EXPECT_GT(solved, 300);
  EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace krait::test
