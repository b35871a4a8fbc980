// Groups and their choice against brute force in double precision; their memory at its worst.
#include "krait/search/groups.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "scene_builder.hpp"

namespace krait::test {
namespace {

// Regions of a room and groups of at most `vertices` vertices, in memory that ends where theirs does.
struct Partition {
  explicit Partition(std::uint32_t vertices, const Room& room = random_room(1)) : open(room) {
    Arena counting;
    take(counting, vertices);
    block.resize(counting.needed() / 8);
    members_capacity = counting.needed(Pool::members) / sizeof(Index);
    Arena arena(block.data(), block.size() * 8);
    take(arena, vertices);
    EXPECT_TRUE(regions.reset(Goal::named(0), 0.0F, 0.05F));
    groups.clear({});
  }
  void take(Arena& arena, std::uint32_t vertices) {
    regions.take(arena, open.scene);
    groups.take(arena, open.scene.triangle_count(), vertices);
  }

  OpenScene open;
  std::vector<std::uint64_t> block;
  std::uint64_t members_capacity;
  Regions regions;
  Groups groups;
};

// Eqn 7 by its definition, as a logarithm.
double log_weight(const Regions& regions, Index region, std::uint32_t selections, const GroupWeights& w) {
  const double h = static_cast<double>(regions.cost(region)), most = static_cast<double>(regions.largest_cost());
  if (!std::isfinite(h)) return -std::numeric_limits<double>::infinity();
  return static_cast<double>(w.alpha) * std::log(static_cast<double>(w.epsilon) + 1 - h / most) +
         static_cast<double>(w.beta < 1 ? std::log(static_cast<double>(w.beta)) : 0) * selections;
}

TEST(Groups, SelectsTheLargestWeightOfEqn7) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Partition p(20'000, random_room(seed));
    std::mt19937 random(seed);
    const GroupWeights weights{uniform_float(random, 1, 16), uniform_float(random, 0.5, 0.95), 0.01F};
    p.groups.clear(weights);
    std::map<Index, std::uint32_t> selections;  // of every group
    Index vertex = 0;
    for (int i = 0; i < 5000; ++i) {
      if (i == 0 || random() % 4 == 0) {
        Index region = p.regions.region(below(random, p.open.scene.triangle_count()));
        while (i == 0 && p.regions.cost(region) == kInfinity)
          region = p.regions.region(below(random, p.open.scene.triangle_count()));
        p.groups.insert(p.regions, region, vertex++);
        selections.insert({region, 0});
      }
      if (random() % 20 == 0) {
        p.regions.raise_edges(p.regions.region(below(random, p.open.scene.triangle_count())), {50.0F, 0.7F});
        p.regions.update();
        p.groups.weigh(p.regions);
      }
      double best = -std::numeric_limits<double>::infinity();
      for (const auto& [region, count] : selections)
        best = std::max(best, log_weight(p.regions, region, count, weights));
      const Index chosen = p.groups.select();
      ASSERT_EQ(selections.count(chosen), 1U);
      const double got = log_weight(p.regions, chosen, selections[chosen], weights);
      ASSERT_NEAR(got, best, 1e-5 * (1 + std::abs(best))) << i;
      ++selections[chosen];
      ASSERT_EQ(p.groups.selections(chosen), selections[chosen]);
    }
    ASSERT_EQ(p.groups.count(), selections.size());
  }
}

TEST(Groups, EqualWeightsGoToTheSmallestRegion) {
  Partition p(1000);
  ASSERT_TRUE(p.regions.reset(Goal::disc({6, 6}, 3), 0.0F, 0.05F));
  std::vector<Index> sources;  // all of cost 0
  for (Index t = 0; t < p.open.scene.triangle_count(); ++t) {
    if (p.regions.is_goal(t)) sources.push_back(t);
  }
  ASSERT_GT(sources.size(), 5U);
  for (std::size_t i = sources.size(); i > 0; --i) p.groups.insert(p.regions, sources[i - 1], 0);
  for (const Index expected : sources) EXPECT_EQ(p.groups.select(), expected);
}

TEST(Groups, WithoutAFiniteCostNoneIsSelected) {
  Room room;
  room.bounds = {0, 0, 10, 4};
  room.boxes = {{4, 0, 5, 4}};
  room.goals = {{8, 0, 10, 4}};
  Partition p(10, room);
  EXPECT_EQ(p.groups.select(), kNone);
  Index cut_off = 0;
  while (p.regions.cost(cut_off) != kInfinity) ++cut_off;
  p.groups.insert(p.regions, cut_off, 0);
  EXPECT_EQ(p.groups.select(), kNone);
  EXPECT_EQ(p.groups.selections(cut_off), 0U);
}

TEST(Groups, SelectionsAreCountedManyThousandTimesWithoutUnderflow) {
  Partition p(10);
  p.groups.clear({8.0F, 0.5F, 0.01F});
  Index a = 0;
  while (p.regions.cost(p.regions.region(a)) == kInfinity || p.regions.region(a) == p.regions.goal_region()) ++a;
  const Index goal = p.regions.goal_region();
  p.groups.insert(p.regions, a, 0);
  p.groups.insert(p.regions, goal, 1);
  for (int i = 0; i < 20'000; ++i) ASSERT_NE(p.groups.select(), kNone);
  // After so many, both are selected equally often, but for the head start of the goal.
  EXPECT_NEAR(static_cast<double>(p.groups.selections(a)), 10'000, 40);
  EXPECT_EQ(p.groups.selections(a) + p.groups.selections(goal), 20'000U);
}

TEST(Groups, RandomVertexIsUniformInItsGroup) {
  for (const std::uint32_t size : {1U, 2U, 4U, 5U, 12U, 13U, 28U, 29U, 100U}) {
    Partition p(200);
    for (Index v = 0; v < size; ++v) {
      p.groups.insert(p.regions, 0, 1000 + v);
      p.groups.insert(p.regions, 1, 5000 + v);  // interleaved with another group's
    }
    ASSERT_EQ(p.groups.size(0), size);
    Random random(size);
    std::vector<int> counts(size);
    const int draws = 2000 * static_cast<int>(size);
    for (int i = 0; i < draws; ++i) {
      const Index v = p.groups.random_vertex(0, random);
      ASSERT_GE(v, 1000U);
      ASSERT_LT(v, 1000U + size);
      ++counts[v - 1000];
    }
    double chi_square = 0;
    for (const int c : counts) chi_square += (c - 2000.0) * (c - 2000.0) / 2000.0;
    const double freedom = size - 1.0;
    EXPECT_LE(chi_square, freedom + 5 * std::sqrt(2 * freedom) + 1e-9) << size;
  }
}

// Inserts vertices by `region_of` and checks that the members stay in their pool after each.
template <class RegionOf>
void fill(std::uint32_t vertices, RegionOf region_of) {
  static const Partition p(2);
  const Index regions = p.open.scene.triangle_count();
  Groups groups;
  Arena counting;
  groups.take(counting, regions, vertices);
  std::vector<std::uint64_t> block(counting.needed() / 8);
  Arena arena(block.data(), block.size() * 8);
  groups.take(arena, regions, vertices);
  groups.clear({});
  const std::uint64_t capacity = counting.needed(Pool::members) / sizeof(Index);
  for (Index v = 0; v < vertices; ++v) {
    groups.insert(p.regions, region_of(v, regions), v);
    ASSERT_LE(groups.members_used(), capacity) << "vertex " << v << " of " << vertices;
  }
}

TEST(Groups, MembersNeverOutgrowTheirPool) {
  for (std::uint32_t n = 2; n < 600; ++n) {
    fill(n, [](Index, Index) { return Index{0}; });                      // one group
    fill(n, [](Index v, Index regions) { return v % regions; });         // as many groups as can be
    fill(n, [](Index v, Index) { return v / 5; });                       // five each: a second block begun
    fill(n, [](Index v, Index regions) { return (v / 13) % regions; });  // a third block begun
  }
}

TEST(Groups, MembersNeverOutgrowTheirPoolAtTheSizesThatBeginABlock) {
  for (std::uint32_t blocks = 1; blocks <= 14; ++blocks) {
    const std::uint32_t full = 4 * ((1U << blocks) - 1);
    for (const std::uint32_t n : {full - 1, full, full + 1}) {
      fill(n, [](Index, Index) { return Index{0}; });
      fill(n, [](Index v, Index) { return v % 2; });
      fill(n, [](Index v, Index regions) { return std::min(v, regions - 1); });
    }
  }
}

TEST(Groups, MembersNeverOutgrowTheirPoolInRandomDistributions) {
  std::mt19937 random(9);
  for (int i = 0; i < 200; ++i) {
    const std::uint32_t n = 2 + below(random, 2000), some = 1 + below(random, 50);
    fill(n, [&](Index, Index regions) { return below(random, std::min(some, regions)); });
  }
}

TEST(Groups, EveryVertexCanBeDrawnFromAFullPool) {
  constexpr std::uint32_t kVertices = 1021;
  Partition p(kVertices);
  const Index groups = 7;
  for (Index v = 0; v < kVertices; ++v) p.groups.insert(p.regions, v % groups, v);
  std::vector<bool> seen(kVertices);
  Random random(1);
  for (int i = 0; i < 40'000; ++i) {
    const Index group = static_cast<Index>(i) % groups;
    const Index v = p.groups.random_vertex(group, random);
    ASSERT_LT(v, kVertices);
    ASSERT_EQ(v % groups, group);
    seen[v] = true;
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), kVertices);
}

}  // namespace
}  // namespace krait::test
