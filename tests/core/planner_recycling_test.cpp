// SPDX-License-Identifier: Apache-2.0
// Searches in too little memory: they go on with what they have, and what they call a plan is one.
#include <algorithm>
#include <random>

#include "planner_fixture.hpp"
#include "search/adaptive_search.hpp"
#include "step_oracle.hpp"

namespace krait::test::planner_recycling_test {
namespace {

constexpr float kStart[] = {2, 6, 0};

class PlannerRecycling : public ::testing::Test {
 protected:
  using TestBench = Bench<Unicycle>;

  // That a solved search has a plan from the start to the goal, driven without touching anything.
  static void expect_plan(const TestBench& bench) {
    const auto plan = bench.planner.plan();
    ASSERT_FALSE(plan.empty());
    const Path path(plan);
    ASSERT_EQ(path.controls.size(), plan.steps());
    ASSERT_EQ(path.states.front(), std::vector<float>(kStart, kStart + 3));
    const auto& last = path.states.back();
    ASSERT_TRUE(Goal::named(0).contains(bench.open.scene, {last[0], last[1]}, 0.0F));
    for (std::size_t i = 0; i < path.controls.size(); ++i) {
      const auto next = step(bench.robot, path.states[i], path.controls[i], plan.dt());
      for (std::size_t k = 0; k < next.size(); ++k) ASSERT_NEAR(wide(next[k]), wide(path.states[i + 1][k]), 1e-5);
      ASSERT_GT(separation_of_step(bench.robot, bench.open.scene, path.states[i], path.controls[i], plan.dt(), 10), 0);
    }
    ASSERT_EQ(plan.hash(), bench.planner.statistics().hash);
  }

  static void expect_root_kept(const TestBench& bench) {
    const detail::MotionTree& tree = detail::opened(bench.planner).tree();
    ASSERT_EQ(tree.branch(0).expansion, kNone);
    ASSERT_EQ(std::vector<float>(tree.state(0), tree.state(0) + 3), std::vector<float>(kStart, kStart + 3));
  }
};

TEST_F(PlannerRecycling, TheSmallestPoolsNeitherCrashNorHangNorLie) {
  TestBench bench(two_rooms(), small_unicycle());
  bench.limits.iterations = 400;
  int solved = 0;
  for (const WhenFull when_full : {WhenFull::recycle, WhenFull::stop}) {
    for (const std::uint32_t vertices : {2U, 3U, 4U, 5U, 7U, 12U, 40U}) {
      for (const std::uint32_t expansions : {2U, 3U, 4U, 6U, 11U, 40U}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
          bench.limits.when_full = when_full;
          bench.limits.vertices = vertices;
          bench.limits.expansions = expansions;
          ASSERT_TRUE(bench.init().ok());
          const Status status = bench.solve({kStart, Goal::named(0), seed});
          ASSERT_LE(detail::opened(bench.planner).tree().vertices(), vertices);
          ASSERT_LE(detail::opened(bench.planner).tree().expansions(), expansions);
          if (status == Status::solved) {
            ++solved;
            expect_plan(bench);
          } else {
            ASSERT_TRUE(bench.planner.plan().empty());
            ASSERT_TRUE(status == Status::tree_full || status == Status::budget_used) << to_string(status);
            if (when_full == WhenFull::recycle) {
              ASSERT_EQ(status, Status::budget_used);
            }
            expect_root_kept(bench);
          }
          if (HasFatalFailure()) FAIL() << vertices << " vertices, " << expansions << " expansions, seed " << seed;
        }
      }
    }
  }
  EXPECT_GE(solved, 20);
}

TEST_F(PlannerRecycling, GoesOnWhereStoppingWouldEnd) {
  int recycled = 0, stopped = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    TestBench bench(two_rooms(1), small_unicycle());
    bench.limits.vertices = 60;
    bench.limits.expansions = 30;
    ASSERT_TRUE(bench.init().ok());
    ASSERT_EQ(bench.solve({kStart, Goal::named(0), seed}), Status::solved) << seed;
    expect_plan(bench);
    if (HasFatalFailure()) return;
    const Statistics statistics = bench.planner.statistics();
    EXPECT_LE(statistics.bytes_used, statistics.bytes_given);
    const bool gave_up = statistics.recycled > 0;
    recycled += gave_up ? 1 : 0;
    bench.limits.when_full = WhenFull::stop;
    ASSERT_TRUE(bench.init().ok());
    // Without recycling, the search is the same up to where memory is wanted.
    const Status status = bench.solve({kStart, Goal::named(0), seed});
    EXPECT_EQ(bench.planner.statistics().recycled, 0U);
    if (!gave_up && status == Status::solved) {
      EXPECT_EQ(bench.planner.statistics().hash, statistics.hash);
    }
    stopped += status == Status::tree_full ? 1 : 0;
  }
  EXPECT_GT(recycled, 5);
  EXPECT_GT(stopped, 5);
}

TEST_F(PlannerRecycling, HowTheSearchIsCutDoesNotMatter) {
  for (const auto& [vertices, expansions] : {std::pair{2U, 2U}, {9U, 5U}, {60U, 20U}, {20U, 200U}}) {
    TestBench whole(two_rooms(1), small_unicycle()), cut(two_rooms(1), small_unicycle());
    for (auto* bench : {&whole, &cut}) {
      bench->limits = {vertices, expansions, 600};
      ASSERT_TRUE(bench->init().ok());
    }
    std::mt19937 random(vertices);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Query query{kStart, Goal::named(0), seed};
      const Status status = whole.solve(query);
      (void)cut.planner.start(query);
      int watched = 0;
      while (cut.planner.advance(below(random, 12), [&](auto, auto) { ++watched; }) == Status::searching) continue;
      EXPECT_EQ(cut.planner.status(), status);
      const Statistics a = whole.planner.statistics(), b = cut.planner.statistics();
      EXPECT_EQ(a.iterations, b.iterations);
      EXPECT_EQ(a.vertices, b.vertices);
      EXPECT_EQ(b.vertices, static_cast<std::uint64_t>(watched) + 1);
      EXPECT_EQ(a.recycled, b.recycled);
      EXPECT_EQ(a.collision_checks, b.collision_checks);
      EXPECT_EQ(a.regions_repaired, b.regions_repaired);
      EXPECT_EQ(a.bytes_used, b.bytes_used);
      EXPECT_EQ(a.hash, b.hash);
    }
  }
}

// Every kept state is counted: those in the tree, and those given up.
TEST_F(PlannerRecycling, WhatIsGivenUpIsCounted) {
  TestBench bench(two_rooms(0.55), small_unicycle());
  bench.limits = {50, 1000, 300};
  bench.parameters.tuning.group_sample = kUnboundedSample;
  bench.parameters.tuning.path_lengths = 0.0F;  // so that the search lasts
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.planner.start({kStart}), Status::searching);
  std::uint64_t before = 0;
  while (bench.planner.advance(1) == Status::searching) {
    const Statistics now = bench.planner.statistics();
    ASSERT_GE(now.recycled, before);
    ASSERT_LE(now.recycled + detail::opened(bench.planner).tree().vertices(), now.vertices);
    before = now.recycled;
  }
  EXPECT_GT(before, 50U);
  expect_root_kept(bench);
}

// Groups and tree agree on which vertices there are. A vertex on an edge may be in either region.
TEST_F(PlannerRecycling, EveryVertexIsInOneGroup) {
  TestBench bench(two_rooms(0.55), small_unicycle());
  bench.limits = {40, 15, 300};
  ASSERT_TRUE(bench.init().ok());
  ASSERT_EQ(bench.planner.start({kStart}), Status::searching);
  while (bench.planner.advance(1) == Status::searching) {
    std::vector<int> seen(40);
    std::uint32_t members = 0;
    for (Index region = 0; region < bench.open.scene.triangle_count(); ++region) {
      detail::opened(bench.planner).groups().for_each_vertex(region, [&](Index vertex) {
        ++seen.at(vertex);
        const float* state = detail::opened(bench.planner).tree().state(vertex);
        const Index triangle = detail::locate(bench.open.scene, {state[0], state[1]}, region);
        EXPECT_EQ(detail::opened(bench.planner).regions().region(triangle), region);
        ++members;
      });
    }
    ASSERT_EQ(members, detail::opened(bench.planner).tree().vertices());
    ASSERT_LE(*std::max_element(seen.begin(), seen.end()), 1);
    ASSERT_EQ(seen[0], 1);
  }
}

TEST_F(PlannerRecycling, NothingOutsideTheBlockIsWrittenInTheSmallestPools) {
  for (const std::uint32_t size : {2U, 3U, 10U, 33U}) {
    TestBench bench(two_rooms(1), small_unicycle());
    bench.limits = {size, size, 200};
    expect_nothing_written_outside(bench, kStart);
  }
}

}  // namespace
}  // namespace krait::test::planner_recycling_test
