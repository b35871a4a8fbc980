// SPDX-License-Identifier: Apache-2.0
// Ways are looked at before one is driven: targets in sight, sketches, and giving up.
#include <algorithm>
#include <numeric>
#include <vector>

#include "planner_fixture.hpp"
#include "search/adaptive_search.hpp"

namespace krait::test::planner_ways_test {
namespace {

constexpr float kStart[] = {2, 6, 0};

Parameters without_looks() {
  Parameters parameters;
  parameters.tuning.sight_tries = 0;
  parameters.tuning.candidates = 0;
  return parameters;
}

std::uint64_t hash_with(const Parameters& parameters) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  bench.parameters = parameters;
  EXPECT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.solve({kStart}), Status::solved);
  return bench.planner.statistics().hash;
}

TEST(PlannerWays, AreNotThePapers) {
  EXPECT_EQ(Parameters::paper().tuning.sight_tries, 0U);
  EXPECT_EQ(Parameters::paper().tuning.candidates, 0U);
  EXPECT_EQ(Parameters::paper().tuning.slowest, 0.75F);
  EXPECT_NE(hash_with({}), hash_with(without_looks()));
}

// Of searches with seeds 1, 2, …, each of which is solved where `solved` says so.
template <class R>
std::vector<std::uint64_t> vertices_of(Bench<R>& bench, const float* start, std::uint64_t searches, bool solved) {
  EXPECT_TRUE(bench.init().ok());
  std::vector<std::uint64_t> vertices;
  for (std::uint64_t seed = 1; seed <= searches; ++seed) {
    const Status status = bench.solve({start, Goal::named(0), seed});
    if (solved) {
      EXPECT_EQ(status, Status::solved);
    }
    vertices.push_back(bench.planner.statistics().vertices);
  }
  return vertices;
}

std::uint64_t sum(const std::vector<std::uint64_t>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), std::uint64_t{0});
}

// Over some searches of a train through a door.
std::uint64_t vertices_with(const Parameters& parameters) {
  ChainParameters chain;
  chain.trailers = 4;
  Bench<Snake> bench(two_rooms(1.4), Snake(chain));
  bench.parameters = parameters;
  const float start[] = {4, 6, 0, 0, 0, 0, 0, 0, 0};
  return sum(vertices_of(bench, start, 200, true));
}

TEST(PlannerWays, TakeFewerVerticesThanAnyWay) {
  Parameters sketches;
  sketches.tuning.sight_tries = 0;
  const std::uint64_t without = vertices_with(without_looks());
  EXPECT_LT(vertices_with(sketches), without);
  EXPECT_LT(static_cast<double>(vertices_with({})), 0.6 * static_cast<double>(without));
}

// A door 1.5 times as wide as the robot. With lines of sight of 1.6 times its width the 90th percentile is 39,210.
TEST(PlannerWays, LookThroughDoorsThatTheRobotFits) {
  Bench<Unicycle> bench(two_rooms(0.6), small_unicycle());
  std::vector<std::uint64_t> vertices = vertices_of(bench, kStart, 60, false);
  std::sort(vertices.begin(), vertices.end());
  EXPECT_LE(vertices[54], 5000U);
}

// In triangles of a quarter of the robot's length the next 6 are less than a length long.
TEST(PlannerWays, LookAsFarWhereRegionsAreSmall) {
  Room fine = two_rooms(0.6);
  fine.spacing = 0.125;
  std::uint64_t vertices[2] = {};
  for (const bool far : {false, true}) {
    Bench<Unicycle> bench(fine, small_unicycle());
    if (!far) bench.parameters.tuning.path_lengths = 0.0F;
    vertices[far] = sum(vertices_of(bench, kStart, 40, true));
  }
  EXPECT_LT(2 * vertices[true], vertices[false]);
}

// Where no sketch is long enough nothing is driven, and the regions ahead get dearer.
TEST(PlannerWays, ThatEndTooSoonAreGivenUpAndRaiseCosts) {
  Bench<Unicycle> bench(two_rooms(0.8), small_unicycle());
  bench.parameters.tuning.sight_tries = 0;
  bench.parameters.tuning.candidates = 1;
  bench.parameters.tuning.kappa = 1;
  ASSERT_TRUE(bench.init().ok());
  int given_up = 0, raised = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    EXPECT_EQ(bench.planner.start({kStart, Goal::named(0), seed}), Status::searching);
    while (bench.planner.status() == Status::searching && !detail::opened(bench.planner).driving()) {
      const std::uint64_t before = bench.planner.statistics().regions_repaired;
      int steps = 0;
      (void)bench.planner.advance(1, [&](const float*, const float*) { ++steps; });
      if (steps > 0) continue;
      ++given_up;
      raised += bench.planner.statistics().regions_repaired > before ? 1 : 0;
    }
  }
  EXPECT_GT(given_up, 20);
  EXPECT_GT(raised, given_up / 2);
}

// Whatever the parameters, the searches end and their plans are the same however they are cut into calls.
TEST(PlannerWays, AtTheEndsOfTheirRangesStillFindPlans) {
  for (const std::uint32_t tries : {0U, 64U}) {
    for (const std::uint32_t candidates : {0U, 1U, 8U}) {
      Parameters parameters;
      parameters.tuning.sight_tries = tries;
      parameters.tuning.candidates = candidates;
      parameters.tuning.least_sketch = 0;
      EXPECT_NE(hash_with(parameters), 0U);
    }
  }
}

}  // namespace
}  // namespace krait::test::planner_ways_test
