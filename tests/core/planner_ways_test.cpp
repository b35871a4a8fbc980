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
  EXPECT_EQ(Parameters::paper().tuning.stopping_ways, 0.0F);
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

// It takes twenty seconds and 100 m to its top speed, or from it to rest.
Truck weakly_braked() {
  ChainParameters chain;
  chain.trailers = 1;
  chain.max_speed = 10.0F;
  chain.max_acceleration = 0.2F;
  return Truck(chain);
}

constexpr float kTruckStart[] = {3, 6, 0, 0, 0, 0};

// Four halls of 15 m by 12 m, with doors of 1.6 m at alternate ends of the walls.
Room halls() {
  Room room;
  room.bounds = {0, 0, 60, 12};
  room.boxes = {{15, 0, 15.25, 9.4},  {15, 11, 15.25, 12}, {30, 0, 30.25, 1},
                {30, 2.6, 30.25, 12}, {45, 0, 45.25, 9.4}, {45, 11, 45.25, 12}};
  room.goals = {{55, 5, 57, 7}};
  return room;
}

// Looks at each expansion's target: it is slowed for where, and as far as, the robot could not stop there.
struct SlowedFor {
  const detail::AdaptiveSearch* search;
  const Truck* robot;
  int* slowed;

  void expands(Index vertex, const Target& target) const {
    const StateView state(search->tree().state(vertex), robot->state_size());
    const float way = std::abs(robot->stopping_way(state));
    const float distance = length(target.point - position(state));
    const float share = robot->speed(state) / robot->top_speed();
    const bool slow = distance < way;
    EXPECT_NEAR(std::abs(target.speed), slow ? std::min(1.0F, share) * std::sqrt(distance / way) : 1.0F, 2e-3F);
    *slowed += slow ? 1 : 0;
  }
  void operator()(const float*, const float*) const {}
};

TEST(PlannerWays, EndWhereTheRobotCanStop) {
  const Truck robot = weakly_braked();
  Bench<Truck, detail::AdaptiveSearch> bench(halls(), robot);
  ASSERT_TRUE(bench.init().ok());
  int slowed = 0;
  const SlowedFor watch{&bench.planner, &robot, &slowed};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    ASSERT_EQ(bench.planner.start({kTruckStart, Goal::named(0), seed}), Status::searching);
    (void)bench.planner.advance(100, watch);
  }
  EXPECT_GT(slowed, 100);
}

TEST(PlannerWays, AreFoundByARobotWithWeakBrakes) {
  std::vector<std::uint64_t> vertices[2];
  for (const bool slows : {false, true}) {
    Bench<Truck> bench(halls(), weakly_braked());
    bench.limits.iterations = 20'000;
    if (!slows) bench.parameters.tuning.stopping_ways = 0.0F;
    vertices[slows] = vertices_of(bench, kTruckStart, 20, slows);
    std::sort(vertices[slows].begin(), vertices[slows].end());
  }
  EXPECT_LE(vertices[true][10], 2000U);
  EXPECT_GE(vertices[false][10], 3 * vertices[true][10]);
}

// Its wheels need some way to turn, and as much to be straight again.
TEST(PlannerWays, AreFoundByARobotWithSlowWheels) {
  ChainParameters p;
  p.trailers = 1;
  p.max_speed = 8.0F;
  p.max_steering_rate = 0.5F;
  Bench<Truck> bench(halls(), Truck(p));
  bench.limits.iterations = 20'000;
  std::vector<std::uint64_t> vertices = vertices_of(bench, kTruckStart, 20, true);
  std::sort(vertices.begin(), vertices.end());
  EXPECT_LE(vertices[10], 3000U);
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
