// SPDX-License-Identifier: Apache-2.0
// The adaptive search with shortcuts and without.
#include "rivals.hpp"
#include "step_oracle.hpp"

namespace krait::test::plain_test {
namespace {

constexpr float kStart[] = {2, 6, 0};

template <class P>
Statistics solved(Bench<Unicycle, P>& bench, std::uint64_t seed) {
  bench.parameters.tuning.kappa = 1;
  EXPECT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.solve({kStart, Goal::named(0), seed}), Status::solved);
  return bench.planner.statistics();
}

// What shortcuts prove Box2D finds as well, and repaired costs are those of Dijkstra to the bit.
TEST(PlainPlanner, FindsTheSamePlanWhereStatesAreCheckedAlone) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Bench<Unicycle> with(two_rooms(0.8), small_unicycle());
    Bench<Unicycle, PlainPlanner> without(two_rooms(0.8), small_unicycle());
    with.parameters.tuning.continuous = without.parameters.tuning.continuous = false;
    const Statistics expected = solved(with, seed), found = solved(without, seed);
    EXPECT_EQ(found.hash, expected.hash);
    EXPECT_EQ(found.iterations, expected.iterations);
  }
}

template <class P>
class WithAndWithoutShortcuts : public ::testing::Test {};
using Both = ::testing::Types<Planner, PlainPlanner>;
TYPED_TEST_SUITE(WithAndWithoutShortcuts, Both);

TYPED_TEST(WithAndWithoutShortcuts, RepairsOrRunsDijkstraAndPlansAsSafely) {
  constexpr bool kPlain = std::is_same_v<TypeParam, PlainPlanner>;
  Bench<Unicycle, TypeParam> bench(two_rooms(0.8), small_unicycle());
  std::uint64_t seed = 1;
  Statistics statistics = solved(bench, seed);
  while (seed < 50 && statistics.regions_repaired == 0 && statistics.dijkstra_runs <= 1) {
    statistics = solved(bench, ++seed);
  }
  EXPECT_EQ(statistics.dijkstra_runs > 1, kPlain);
  EXPECT_EQ(statistics.regions_repaired > 0, !kPlain);
  const Path path(bench.planner.plan());
  for (std::size_t i = 0; i < path.controls.size(); ++i) {
    ASSERT_GT(separation_of_step(bench.robot, bench.open.scene, path.states[i], path.controls[i], 0.1F, 8), 0.0);
  }
}

}  // namespace
}  // namespace krait::test::plain_test
