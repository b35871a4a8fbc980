// SPDX-License-Identifier: Apache-2.0
// Searches that begin anew: when, from what, and what stays.
#include <algorithm>

#include "decomposition/locate.hpp"
#include "planner_fixture.hpp"
#include "search/adaptive_search.hpp"
#include "search/restarts.hpp"

namespace krait::test::planner_restarts_test {
namespace {

constexpr float kStart[] = {2, 6, 0};

// How many expansions the first tries last.
std::vector<int> tries(std::uint32_t unit, float share, std::size_t count) {
  detail::Restarts restarts;
  restarts.begin(unit, share);
  std::vector<int> lengths;
  int length = 0;
  while (lengths.size() < count) {
    if (restarts.due()) {
      lengths.push_back(length);
      length = 0;
    }
    ++length;
  }
  return lengths;
}

TEST(RestartsOf, LastAsLubysSequenceSays) {
  EXPECT_EQ(tries(1, 1.0F, 15), (std::vector<int>{1, 1, 2, 1, 1, 2, 4, 1, 1, 2, 1, 1, 2, 4, 8}));
  EXPECT_EQ(tries(5, 1.0F, 7), (std::vector<int>{5, 5, 10, 5, 5, 10, 20}));
}

TEST(RestartsOf, LastAShareOfTheUnitAndOneExpansionAtLeast) {
  EXPECT_EQ(tries(10, 2.5F, 3), (std::vector<int>{25, 25, 50}));
  EXPECT_EQ(tries(10, 0.3F, 3), (std::vector<int>{3, 3, 6}));
  EXPECT_EQ(tries(2, 0.1F, 3), (std::vector<int>{1, 1, 2}));
}

TEST(RestartsOf, AreNotDueSoonWhereAUnitWouldOverflow) {
  detail::Restarts restarts;
  restarts.begin(1'000'000'000, 10'000.0F);
  for (int i = 0; i < 10'000; ++i) ASSERT_FALSE(restarts.due());
}

TEST(RestartsOf, AreNeverDueWithoutAUnit) {
  detail::Restarts restarts;
  restarts.begin(0, 1.0F);
  for (int i = 0; i < 10'000; ++i) ASSERT_FALSE(restarts.due());
}

// It looks ahead a little only, so that its searches last. Its way is short: its tries last a tenth of restart_unit.
struct UnitBench : Bench<Unicycle> {
  explicit UnitBench(std::uint32_t unit) : Bench(two_rooms(), small_unicycle()) {
    parameters.tuning.restart_unit = 10 * unit;
    parameters.tuning.path_lengths = 0.0F;
  }
};

TEST(PlannerRestarts, SearchesThatBeginAnewSolveToo) {
  int begun_anew = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    UnitBench bench(5);
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.solve({kStart, Goal::named(0), seed}), Status::solved) << seed;
    begun_anew += bench.planner.statistics().restarts > 0 ? 1 : 0;
    const Path path(bench.planner.plan());
    EXPECT_TRUE(std::equal(std::begin(kStart), std::end(kStart), path.states.front().begin()));
  }
  EXPECT_GT(begun_anew, 10);
}

TEST(PlannerRestarts, DoNotDependOnHowTheSearchIsCut) {
  Statistics whole, pieces;
  for (Statistics* statistics : {&whole, &pieces}) {
    UnitBench bench(3);
    ASSERT_TRUE(bench.init().ok());
    EXPECT_EQ(bench.planner.start({kStart}), Status::searching);
    while (bench.planner.advance(statistics == &whole ? 1'000'000 : 3) == Status::searching) continue;
    *statistics = bench.planner.statistics();
  }
  EXPECT_GT(whole.restarts, 0U);
  EXPECT_EQ(whole.restarts, pieces.restarts);
  EXPECT_EQ(whole.hash, pieces.hash);
  EXPECT_EQ(whole.bytes_used, pieces.bytes_used);
}

// After the last expansion of a try the tree is the start alone, and costs are what they were.
TEST(PlannerRestarts, ForgetWhatTheTryHasLearnt) {
  constexpr std::uint32_t kUnit = 10;
  UnitBench bench(kUnit), fresh(0);
  bench.parameters.tuning.kappa = fresh.parameters.tuning.kappa = 1;
  ASSERT_TRUE(bench.init().ok());
  ASSERT_TRUE(fresh.init().ok());
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    EXPECT_EQ(fresh.planner.start({kStart, Goal::named(0), seed}), Status::searching);
    EXPECT_EQ(bench.planner.start({kStart, Goal::named(0), seed}), Status::searching);
    const auto differs = [&] {
      for (Index r = 0; r < bench.open.scene.triangle_count(); ++r) {
        if (detail::opened(bench.planner).regions().cost(r) != detail::opened(fresh.planner).regions().cost(r))
          return true;
      }
      return false;
    };
    if (bench.planner.advance(kUnit) != Status::searching || !differs()) continue;
    const std::uint32_t most = detail::opened(bench.planner).tree().most_vertices();
    ASSERT_EQ(bench.planner.advance(1), Status::searching);
    if (bench.planner.statistics().iterations == kUnit) continue;  // a way to the goal is driven
    EXPECT_EQ(bench.planner.statistics().restarts, 1U);
    EXPECT_FALSE(differs());
    EXPECT_EQ(detail::opened(bench.planner).tree().vertices(), 1U);
    EXPECT_EQ(detail::opened(bench.planner).tree().expansions(), 0U);
    EXPECT_EQ(detail::opened(bench.planner).tree().most_vertices(), most);
    return;
  }
  FAIL() << "no search lasted long enough";
}

// How many regions there are on the way from the start, and how long the first try of one of 20 searches lasts.
struct FirstTry {
  Index regions = 0;
  std::uint64_t expansions = 0;
};

FirstTry first_try(double spacing, std::uint32_t unit) {
  Room room = two_rooms();
  room.spacing = spacing;
  Bench<Unicycle> bench(room, small_unicycle());
  bench.parameters.tuning.restart_unit = unit;
  bench.parameters.tuning.open_steps = 0;
  bench.parameters.tuning.path_lengths = 0.0F;
  EXPECT_TRUE(bench.init().ok());
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_EQ(bench.planner.start({kStart, Goal::named(0), seed}), Status::searching);
    const detail::AdaptiveSearch& search = detail::opened(bench.planner);
    const Index start = detail::locate(bench.open.scene, {kStart[0], kStart[1]}, kNone);
    const Index regions = search.regions().regions_ahead(search.regions().region(start), kNone);
    while (bench.planner.statistics().restarts == 0 && bench.planner.status() == Status::searching) {
      (void)bench.planner.advance(1);
    }
    if (bench.planner.status() == Status::searching) return {regions, bench.planner.statistics().iterations - 1};
  }
  ADD_FAILURE() << "every search ended within a try";
  return {};
}

// The unit is for a way of 90 regions. On a longer way of n regions the first try lasts 1 + n / 90 of it.
TEST(PlannerRestarts, AreRarerOnALongWay) {
  const FirstTry found = first_try(0.1, 3);
  ASSERT_GE(found.regions, 146U);
  EXPECT_EQ(found.expansions, static_cast<std::uint64_t>(3 + 3 * found.regions / 90.0));
}

// On a shorter way of n regions it lasts (n / 90)² of the unit.
TEST(PlannerRestarts, AreMoreFrequentOnAShortWay) {
  const FirstTry found = first_try(0.4, 50);
  ASSERT_GT(found.regions, 30U);
  ASSERT_LT(found.regions, 80U);
  const double share = found.regions / 90.0;
  EXPECT_EQ(found.expansions, static_cast<std::uint64_t>(50 * share * share));
}

// However short the way is, it lasts a tenth of the unit.
TEST(PlannerRestarts, LastATenthOfTheUnitAtLeast) {
  const FirstTry found = first_try(1.5, 50);
  ASSERT_LT(found.regions, 28U);
  EXPECT_EQ(found.expansions, 5U);
}

TEST(PlannerRestarts, AreNotThePapers) { EXPECT_EQ(Parameters::paper().tuning.restart_unit, 0U); }

}  // namespace
}  // namespace krait::test::planner_restarts_test
