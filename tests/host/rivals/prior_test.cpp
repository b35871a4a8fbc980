// SPDX-License-Identifier: Apache-2.0
// The planner of prior work: its group weights and its choice of vertices by their definition. What holds for every
// planner is tested in planner_*_test.cpp.

#include <cmath>
#include <map>
#include <set>

#include "rivals.hpp"

namespace krait::test::prior_test {
namespace {

using OfUnicycle = PriorPlanner;
using PriorBench = Bench<Unicycle, PriorPlanner>;
using rivals::PriorParameters;

constexpr float kStart[] = {1, 6.6F, 0};

// A dead end on the straight way to a door of one metre: its groups are tried in vain, again and again.
Room dead_end() {
  Room room = two_rooms(1);
  room.boxes.push_back({2, 5.8, 6, 6});
  return room;
}

// The weight of [18] by its definition, as a logarithm, over all regions.
double log_weight(const OfUnicycle& planner, Index region) {
  const detail::Regions& regions = planner.regions();
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (Index t = 0; t < regions.scene().triangle_count(); ++t) {
    const double h = static_cast<double>(regions.cost(regions.region(t)));
    if (!std::isfinite(h)) continue;
    least = std::min(least, h);
    most = std::max(most, h);
  }
  const double h = static_cast<double>(regions.cost(region));
  if (!std::isfinite(h)) return -std::numeric_limits<double>::infinity();
  const double epsilon = 1e-11;
  return 8 * std::log(epsilon + (1 - epsilon) * (most - h) / (most - least)) +
         std::log(double{Parameters().tuning.beta}) * planner.groups().selections(region);
}

std::set<Index> groups_of(const OfUnicycle& planner) {
  std::set<Index> regions;
  for (Index r = 0; r < planner.regions().scene().triangle_count(); ++r) {
    if (planner.groups().size(r) > 0) regions.insert(r);
  }
  return regions;
}

TEST(PriorPlanner, SelectsTheGroupOfTheLargestWeight) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    PriorBench f(dead_end(), small_unicycle());
    ASSERT_TRUE(f.init().ok());
    EXPECT_EQ(f.planner.start({kStart, Goal::named(0), seed}), Status::searching);
    for (int i = 0; i < 300 && f.planner.status() == Status::searching; ++i) {
      std::map<Index, std::uint32_t> selections;
      std::map<Index, double> weights;
      double best = -std::numeric_limits<double>::infinity();
      for (const Index region : groups_of(f.planner)) {
        selections[region] = f.planner.groups().selections(region);
        weights[region] = log_weight(f.planner, region);
        best = std::max(best, weights[region]);
      }
      if (f.planner.driving()) break;
      (void)f.planner.advance(1);
      int grown = 0;
      for (const auto& [region, before] : selections) {
        if (f.planner.groups().selections(region) == before) continue;
        ++grown;
        ASSERT_NEAR(weights[region], best, 1e-4 * (1 + std::abs(best))) << i;
      }
      ASSERT_EQ(grown, 1) << i;
    }
  }
}

TEST(PriorPlanner, CostsNeverChange) {
  PriorBench f(dead_end(), small_unicycle());
  ASSERT_TRUE(f.init().ok());
  EXPECT_EQ(f.planner.start({kStart}), Status::searching);
  std::vector<float> costs;
  const Index triangles = f.open.scene.triangle_count();
  for (Index t = 0; t < triangles; ++t) costs.push_back(f.planner.regions().cost(f.planner.regions().region(t)));
  ASSERT_EQ(f.planner.advance(1'000'000), Status::solved);
  for (Index t = 0; t < triangles; ++t) EXPECT_EQ(f.planner.regions().cost(f.planner.regions().region(t)), costs[t]);
  EXPECT_EQ(f.planner.statistics().dijkstra_runs, 1U);
}

float distance(const float* state, Vec2 point) { return length(point - Vec2{state[0], state[1]}); }

// How near the nearest member of a group is to the point.
float least_distance(const OfUnicycle& planner, Index group, Vec2 point) {
  float least = kInfinity;
  planner.groups().for_each_vertex(
      group, [&](Index vertex) { least = std::min(least, distance(planner.tree().state(vertex), point)); });
  return least;
}

// Runs with every target in a goal too small to matter where; returns how many of the expansions that added vertices
// began at their group's nearest one to it, and how many there were.
std::pair<int, int> nearest_expansions(float nearest_share) {
  PriorParameters prior;
  prior.path_share = 0.0F;
  prior.goal_share = 1.0F;
  prior.nearest_share = nearest_share;
  PriorBench f(dead_end(), small_unicycle(), prior);
  EXPECT_TRUE(f.init().ok());
  const Vec2 center{11, 7};
  EXPECT_EQ(f.planner.start({kStart, Goal::disc(center, 1e-3F), 1}), Status::searching);
  int nearest = 0, all = 0;
  for (int i = 0; i < 400 && f.planner.status() == Status::searching; ++i) {
    std::map<Index, std::pair<std::uint32_t, float>> before;  // by group: selections, nearest member
    for (const Index group : groups_of(f.planner)) {
      before[group] = {f.planner.groups().selections(group), least_distance(f.planner, group, center)};
    }
    float from = kInfinity;  // of the expansion's first state, if it had a step
    const auto watch = [&](const float* state, const float*) {
      if (from == kInfinity) from = distance(state, center);
    };
    (void)f.planner.advance(1, watch);
    if (from == kInfinity) continue;
    ++all;
    for (const auto& [group, then] : before) {
      const bool selected = f.planner.groups().selections(group) > then.first;
      nearest += selected && from <= then.second + 3e-3F ? 1 : 0;
    }
  }
  return {nearest, all};
}

TEST(PriorPlanner, GrowsFromTheNearestVertexOfTheGroup) {
  const auto [nearest, all] = nearest_expansions(1.0F);
  EXPECT_GT(all, 5);
  EXPECT_EQ(nearest, all);
}

TEST(PriorPlanner, GrowsFromAnyVertexOfTheGroupWhereItsShareSaysSo) {
  const auto [nearest, all] = nearest_expansions(0.0F);
  EXPECT_GT(all, 50);
  EXPECT_LT(nearest, all / 2);
}

// Of a target that is drawn anywhere, most tries fall on obstacles, and now and then all.
TEST(PriorPlanner, PlansAlongACorridorWhereNearlyAllIsObstacle) {
  Room room;
  room.bounds = {0, 0, 12, 8};
  room.boxes = {{0, 0.75, 11.25, 8}};
  room.goals = {{11.25, 7, 12, 8}};
  PriorParameters prior;
  prior.path_share = 0.5F;
  prior.goal_share = 0.0F;
  PriorBench bench(room, small_unicycle(), prior);
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {0.5F, 0.375F, 0};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    ASSERT_EQ(bench.solve({start, Goal::named(0), seed}), Status::solved) << seed;
    for (const auto& state : Path(bench.planner.plan()).states) {
      EXPECT_TRUE(state[1] < 0.75F || state[0] > 11.25F) << state[0] << " " << state[1];
    }
  }
}

}  // namespace
}  // namespace krait::test::prior_test
