// SPDX-License-Identifier: Apache-2.0
// Planners with parts of them turned off, as the paper has them or for comparison, and robots whose position lies
// outside their body.
#include <algorithm>

#include "planner_fixture.hpp"
#include "robot_oracle.hpp"
#include "search/adaptive_search.hpp"
#include "step_oracle.hpp"

namespace krait::test::planner_modes_test {
namespace {

constexpr float kStart[] = {2, 6, 0};

template <class R>
double separation_of_state(const R& robot, const Scene& scene, const std::vector<float>& state) {
  return separation_of_state(robot, scene, rings_of_pieces(scene), doubles(state));
}

// A sliver of a centimetre parts the room; the triangles go through it.
Room parted() {
  Room room;
  room.bounds = {0, 0, 12, 8};
  room.goals = {{9, 2, 11, 6}};
  room.loose_pieces = {corners({6, 0, 6.01, 8})};
  return room;
}

TEST(PlannerModes, DiscreteChecksJumpOverWhatContinuousOnesSee) {
  for (const bool continuous : {true, false}) {
    Bench<Slider> bench(parted(), Slider(0.5F, 12.0F));
    bench.parameters.tuning.prune_portals = false;
    bench.parameters.tuning.continuous = continuous;
    bench.limits.iterations = 400;
    ASSERT_TRUE(bench.init().ok());
    const float start[] = {2, 4};
    ASSERT_EQ(bench.solve({start}), continuous ? Status::budget_used : Status::solved);
    if (continuous) continue;
    for (const auto& state : Path(bench.planner.plan()).states) {
      EXPECT_TRUE(state[0] < 5.75F || state[0] > 6.26F) << state[0];
    }
  }
}

TEST(PlannerModes, WithoutPruningADoorTooNarrowIsTriedInVain) {
  Bench<Unicycle> bench(two_rooms(0.3), small_unicycle());
  bench.limits.iterations = 200;
  for (const bool prune : {true, false}) {
    bench.parameters.tuning.prune_portals = prune;
    ASSERT_TRUE(bench.init().ok());
    EXPECT_EQ(bench.planner.start({kStart}), prune ? Status::no_route : Status::searching);
    EXPECT_EQ(bench.planner.advance(1000), prune ? Status::no_route : Status::budget_used);
  }
}

TEST(PlannerPaper, PlansThroughFreeStatesWithinTheLimits) {
  ChainParameters p = small_chain(2);
  p.max_hitch_angle = 0.7F;
  Bench<Snake> bench(two_rooms(), Snake(p));
  bench.parameters = Parameters::paper();
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {2, 6, 0, 0, 0, 0, 0};
  ASSERT_EQ(bench.solve({start, Goal::named(0), 2}), Status::solved);
  for (const auto& state : Path(bench.planner.plan()).states) {
    EXPECT_GT(separation_of_state(bench.robot, bench.open.scene, state), 0.0);
    EXPECT_LE(std::abs(state[2] - state[5]), 0.7F);
    EXPECT_LE(std::abs(state[5] - state[6]), 0.7F);
  }
}

// All of two large triangles is the goal's, so that no failure lies before another region.
TEST(PlannerModes, WhereEveryRegionMeetsTheGoalItIsFoundAndNoCostRises) {
  Room room;
  room.bounds = {0, 0, 12, 8};
  room.spacing = 20;
  Bench<Unicycle> bench(room, small_unicycle());
  bench.parameters.tuning.stray_share = 0.95F;
  bench.parameters.tuning.kappa = 1;
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {1, 1, 0};
  ASSERT_EQ(bench.planner.start({start, Goal::disc({6, 4}, 0.1F)}), Status::searching);
  ASSERT_EQ(detail::opened(bench.planner).regions().largest_cost(), 0.0F);
  EXPECT_EQ(bench.planner.advance(20'000), Status::solved);
  EXPECT_EQ(bench.planner.statistics().regions_repaired, 0U);
}

// The expansions from each update of a try to the next, and the regions that the former found anew. The searches
// look ahead a little only, so that they last.
struct Updates {
  std::vector<std::uint64_t> waits, repaired;
};

Updates updates_of(std::uint32_t kappa, std::uint32_t update_regions) {
  Bench<Unicycle> bench(two_rooms(0.6), small_unicycle());
  bench.parameters.tuning.kappa = kappa;
  bench.parameters.tuning.update_regions = update_regions;
  bench.parameters.tuning.path_lengths = 0.0F;
  EXPECT_TRUE(bench.init().ok());
  const float start[] = {2, 6, 0};
  Updates updates;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    EXPECT_EQ(bench.planner.start({start, Goal::named(0), seed}), Status::searching);
    Statistics last = bench.planner.statistics();  // at the last update, or where the try began
    std::uint64_t repaired = 0;                    // by the last update of this try
    while (bench.planner.advance(1) == Status::searching) {
      const Statistics now = bench.planner.statistics();
      const bool another_try = now.restarts != last.restarts;
      if (!another_try && now.regions_repaired == last.regions_repaired) continue;
      if (!another_try && repaired > 0) {
        updates.waits.push_back(now.iterations - last.iterations);
        updates.repaired.push_back(repaired);
      }
      repaired = another_try ? 0 : now.regions_repaired - last.regions_repaired;
      last = now;
    }
  }
  EXPECT_GT(updates.waits.size(), 10U);
  return updates;
}

TEST(PlannerUpdates, WaitForAnExpansionForSoManyRegionsOfTheLastOne) {
  constexpr std::uint32_t kRegions = 4;
  const Updates updates = updates_of(1, kRegions);
  std::uint64_t longest = 0;
  for (std::size_t i = 0; i < updates.waits.size(); ++i) {
    EXPECT_GE(updates.waits[i], updates.repaired[i] / kRegions);
    longest = std::max(longest, updates.waits[i]);
  }
  EXPECT_GT(longest, 3U);
}

TEST(PlannerUpdates, DoNotWaitWhereTheLastOneWasCheap) {
  for (const std::uint32_t update_regions : {0U, 1'000'000U}) {
    const Updates updates = updates_of(1, update_regions);
    EXPECT_EQ(*std::min_element(updates.waits.begin(), updates.waits.end()), 1U);
    for (const std::uint64_t wait : updates_of(7, update_regions).waits) EXPECT_EQ(wait % 7, 0U);
  }
  EXPECT_EQ(Parameters::paper().tuning.update_regions, 0U);
}

// Vertices of 20 searches of a unicycle for a goal of a fifth of its length.
std::uint64_t vertices_to_small_goal(float goal_near_radius) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  bench.parameters.tuning.goal_near_radius = goal_near_radius;
  EXPECT_TRUE(bench.init().ok());
  std::uint64_t vertices = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_EQ(bench.solve({kStart, Goal::disc({10, 2}, 0.1F), seed}), Status::solved);
    vertices += bench.planner.statistics().vertices;
  }
  return vertices;
}

TEST(PlannerModes, AnExpansionTowardATargetInTheGoalEndsInTheGoal) {
  const Parameters parameters;
  EXPECT_LT(3 * vertices_to_small_goal(parameters.tuning.goal_near_radius),
            2 * vertices_to_small_goal(parameters.tuning.near_radius));
  EXPECT_EQ(Parameters::paper().tuning.goal_near_radius, Parameters::paper().tuning.near_radius);
}

// The body begins 0.6 m ahead of the position.
Unicycle arm() {
  UnicycleParameters p;
  p.min_speed = -1.0F;
  Unicycle robot(p);
  const Vec2 body[] = {{0.6F, -0.2F}, {1, -0.2F}, {1, 0.2F}, {0.6F, 0.2F}};
  robot.set_body(0, {body, 4});
  return robot;
}

TEST(PlannerModes, APositionOutsideItsBodyMayPassOverAnObstacle) {
  Room room = two_rooms();
  const Rect post{1.5, 5.9, 1.75, 6.1};
  room.boxes.push_back(post);
  Bench<Unicycle> bench(room, arm());
  bench.parameters.tuning.reverse_share = 1.0F;
  bench.limits.iterations = 500;
  ASSERT_TRUE(bench.init().ok());
  int over = 0;
  double least = kInfinity;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    EXPECT_EQ(bench.planner.start({kStart, Goal::disc({1.2F, 6}, 0.05F), seed}), Status::searching);
    (void)bench.planner.advance(500, [&](const float*, const float* to) {
      if (!building::holds(post, wide(to[0]), wide(to[1]))) return;
      ++over;
      least = std::min(least, separation_of_state(bench.robot, bench.open.scene, {to, to + 3}));
    });
  }
  EXPECT_GT(over, 0);
  EXPECT_GT(least, 0.0);
}

TEST(PlannerModes, APositionOnAnObstacleIsNoStart) {
  Room room = two_rooms();
  room.boxes.push_back({1.2, 5.8, 1.5, 6.2});
  Bench<Unicycle> bench(room, arm());
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {1.35F, 6, 0};
  ASSERT_GT(separation_of_state(bench.robot, bench.open.scene, {start, start + 3}), 0.0);
  EXPECT_EQ(bench.planner.start({start}), Status::start_in_collision);
}

// No disc around the position lies in the body: the one around the body's middle tells.
TEST(PlannerModes, NoRouteAtOnceThroughADoorNarrowerThanABodyThatIsElsewhere) {
  for (const double door : {0.35, 0.6}) {
    Bench<Unicycle> bench(two_rooms(door), arm());
    ASSERT_TRUE(bench.init().ok());
    EXPECT_EQ(bench.planner.start({kStart}), door < 0.4 ? Status::no_route : Status::searching) << door;
  }
}

}  // namespace
}  // namespace krait::test::planner_modes_test
