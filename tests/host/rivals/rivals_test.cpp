// SPDX-License-Identifier: Apache-2.0
// What holds for both rivals: they do without what the adaptive planner adds, and share its memory, plans and answers.
#include "rivals.hpp"

#include "robot_oracle.hpp"
#include "step_oracle.hpp"

namespace krait::test::rivals_test {
namespace {

constexpr float kStart[] = {2, 6, 0};

template <class P>
class Rival : public ::testing::Test {
 protected:
  using TestBench = Bench<Unicycle, P>;

  static Statistics solved(const Parameters& parameters, std::uint64_t seed = 1, std::uint64_t piece = 1'000'000'000) {
    TestBench bench(two_rooms(), small_unicycle());
    bench.parameters = parameters;
    EXPECT_TRUE(bench.init().ok());
    EXPECT_EQ(bench.planner.start({kStart, Goal::named(0), seed}), Status::searching);
    while (bench.planner.advance(piece) == Status::searching) continue;
    EXPECT_EQ(bench.planner.status(), Status::solved);
    return bench.planner.statistics();
  }
};
using Rivals = ::testing::Types<PriorPlanner, RrtPlanner>;
struct RivalNames {
  template <class P>
  static std::string GetName(int) {
    return std::is_same_v<P, PriorPlanner> ? "prior" : "rrt";
  }
};
TYPED_TEST_SUITE(Rival, Rivals, RivalNames);

TYPED_TEST(Rival, HasNoUseForWhatTheAdaptivePlannerAdds) {
  const std::uint64_t hash = this->solved({}).hash;
  const auto change = [](auto set) {
    Parameters parameters;
    set(parameters);
    return parameters;
  };
  EXPECT_EQ(this->solved(change([](Parameters& p) { p.tuning.doomed_steps = 0; })).hash, hash);
  EXPECT_EQ(this->solved(change([](Parameters& p) { p.tuning.open_steps = 0; })).hash, hash);
  EXPECT_EQ(this->solved(change([](Parameters& p) { p.tuning.sight_tries = p.tuning.candidates = 0; })).hash, hash);
  EXPECT_EQ(this->solved(change([](Parameters& p) { p.tuning.slowest = 0.1F; })).hash, hash);
  EXPECT_EQ(this->solved(change([](Parameters& p) { p.tuning.restart_unit = 1; })).restarts, 0U);
  EXPECT_NE(this->solved(change([](Parameters& p) { p.tuning.max_steps = 20; })).hash, hash);
}

TYPED_TEST(Rival, DoesNotDependOnHowTheSearchIsCut) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    EXPECT_EQ(this->solved({}, seed, 1).hash, this->solved({}, seed).hash);
    EXPECT_EQ(this->solved({}, seed, 7).hash, this->solved({}, seed).hash);
  }
}

TYPED_TEST(Rival, EndsAtAnySpeed) {
  Bench<Car, TypeParam> bench(two_rooms(), Car(Car::defaults()));
  ASSERT_TRUE(bench.init().ok());
  std::vector<float> start(5);
  bench.robot.rest({4, 6}, 0.0F, nullptr, start.data());
  ASSERT_EQ(bench.solve({start.data()}), Status::solved);
  EXPECT_GT(bench.planner.statistics().plan_end_speed, 1.0F);
}

TYPED_TEST(Rival, RefusesOtherHeadings) {
  Bench<Unicycle, TypeParam> bench(two_rooms(3), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {3, 4, 0};
  ASSERT_EQ(bench.solve({start, Goal::pose({9, 4}, 1, 0.5F * kPi, 0.5F), 1}), Status::solved);
  const std::vector<float> last = Path(bench.planner.plan()).states.back();
  EXPECT_LE(std::hypot(last[0] - 9, last[1] - 4), 1.0F);
  EXPECT_LE(std::abs(std::remainder(last[2] - 0.5F * kPi, 2 * kPi)), 0.5F);
}

TYPED_TEST(Rival, TouchesNothing) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Bench<Unicycle, TypeParam> bench(two_rooms(1), small_unicycle());
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.solve({kStart, Goal::named(0), seed}), Status::solved) << seed;
    const Path path(bench.planner.plan());
    for (std::size_t i = 0; i < path.controls.size(); ++i) {
      ASSERT_GT(separation_of_step(bench.robot, bench.open.scene, path.states[i], path.controls[i], 0.1F, 10), 0)
          << "seed " << seed << " step " << i;
    }
  }
}

TYPED_TEST(Rival, SpendsTheBlockAndSaysWhenItIsTooSmall) {
  Bench<Unicycle, TypeParam> bench(two_rooms(), small_unicycle());
  const std::uint64_t needed = TypeParam::bytes_required(bench.open.scene, bench.robot, bench.limits);
  ASSERT_TRUE(bench.init(needed).ok());
  EXPECT_EQ(bench.planner.arena().needed(), needed);
  const Failure failure = bench.init(needed - 1);
  EXPECT_EQ(failure.status, Status::arena_too_small);
  EXPECT_EQ(failure.bytes_needed, needed);
  bench.limits.vertices = 0;
  ASSERT_TRUE(bench.init(100'000).ok());
  EXPECT_LE(bench.planner.arena().needed(), 100'000U);
  EXPECT_GT(bench.planner.arena().needed(), 99'900U);
}

// RRT keeps every state, the other gives groups up.
TYPED_TEST(Rival, EndsOrGoesOnWhenTheTreeIsFull) {
  Bench<Unicycle, TypeParam> bench(two_rooms(0.55), small_unicycle());
  bench.limits.vertices = 60;
  bench.limits.expansions = 30;
  bench.limits.iterations = 2000;
  ASSERT_TRUE(bench.init().ok());
  const Status status = bench.solve({kStart});
  if (std::is_same_v<TypeParam, RrtPlanner>) {
    EXPECT_EQ(status, Status::tree_full);
  } else {
    EXPECT_TRUE(status == Status::budget_used || status == Status::solved) << to_string(status);
    EXPECT_GT(bench.planner.statistics().recycled, 0U);
  }
}

}  // namespace
}  // namespace krait::test::rivals_test
