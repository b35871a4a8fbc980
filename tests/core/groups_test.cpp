// SPDX-License-Identifier: Apache-2.0
// Groups, their samples and the choice of one, against brute force.
#include "search/groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "scene_builder.hpp"

namespace krait::test::groups_test {
namespace {

constexpr detail::GroupWeights kWeights{8.0F, 0.85F, 0.01F};

constexpr std::uint32_t kSample = 8;

// Regions of a room and groups of at most `vertices` vertices, in memory that ends where theirs does.
struct Partition {
  explicit Partition(std::uint32_t vertices, const Room& room = random_room(1)) : open(room) {
    detail::Arena counting;
    allocate(counting, vertices);
    block.resize(counting.needed() / 8);
    detail::Arena arena(block.data(), block.size() * 8);
    allocate(arena, vertices);
    EXPECT_TRUE(regions.reset(Goal::named(0), 0.0F, 0.05F));
    groups.clear(kWeights, kSample);
  }
  void allocate(detail::Arena& arena, std::uint32_t vertices) {
    regions.allocate(arena, open.scene);
    groups.allocate(arena, open.scene, vertices);
  }

  Index random_region(std::mt19937& random) const { return regions.region(below(random, open.scene.triangle_count())); }
  // Not the goal's, and connected to it.
  Index region_with_a_cost() const {
    Index r = 0;
    while (regions.cost(regions.region(r)) == kInfinity || regions.region(r) == regions.goal_region()) ++r;
    return r;
  }
  std::vector<Index> members(Index region) const {
    std::vector<Index> result;
    groups.for_each_vertex(region, [&](Index vertex) { result.push_back(vertex); });
    return result;
  }

  OpenScene open;
  std::vector<std::uint64_t> block;
  detail::Regions regions;
  detail::Groups groups;
};

// Eqn 7 by its definition, as a logarithm.
double log_weight(const detail::Regions& regions, Index region, std::uint32_t selections,
                  const detail::GroupWeights& w) {
  const double h = static_cast<double>(regions.cost(region)), most = static_cast<double>(regions.largest_cost());
  if (!std::isfinite(h)) return -std::numeric_limits<double>::infinity();
  return static_cast<double>(w.alpha) * std::log(static_cast<double>(w.epsilon) + 1 - h / most) +
         static_cast<double>(w.beta < 1 ? std::log(static_cast<double>(w.beta)) : 0) * selections;
}

// Groups kept in the simplest way: by region, the members in the order in which they came.
class Reference {
 public:
  Reference(const detail::Regions& regions, const detail::Groups& groups) : regions_(regions), groups_(groups) {}

  // The first region whose weight none exceeds.
  Index best() const {
    Index result = kNone;
    float most = -kInfinity;
    for (const auto& [region, vertices] : members) {
      const float weight = groups_.log_weight(regions_, region);
      if (vertices.empty() || !(weight > most)) continue;
      most = weight;
      result = region;
    }
    return result;
  }

  // The last region with more than the root whose weight none is below.
  Index lightest(Index besides) const {
    Index result = kNone;
    for (const auto& [region, vertices] : members) {
      if (region == besides || vertices.empty() || vertices.back() == detail::kRoot) continue;
      const float weight = groups_.log_weight(regions_, region);
      if (result == kNone || weight <= groups_.log_weight(regions_, result)) result = region;
    }
    return result;
  }

  std::map<Index, std::vector<Index>> members;

 private:
  const detail::Regions& regions_;
  const detail::Groups& groups_;
};

TEST(Groups, SelectsTheLargestWeightOfEqn7) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Partition p(20'000, random_room(seed));
    std::mt19937 random(seed);
    const detail::GroupWeights weights{uniform_float(random, 1, 16), uniform_float(random, 0.5, 0.95), 0.01F};
    p.groups.clear(weights, kUnboundedSample);
    std::map<Index, std::uint32_t> selections;  // of every group
    Index vertex = 0;
    for (int i = 0; i < 5000; ++i) {
      if (i == 0 || random() % 4 == 0) {
        Index region = p.random_region(random);
        while (i == 0 && p.regions.cost(region) == kInfinity) region = p.random_region(random);
        p.groups.insert(p.regions, region, vertex++);
        selections.insert({region, 0});
      }
      if (random() % 20 == 0) {
        p.regions.raise_edges(p.random_region(random), {50.0F, 0.7F});
        p.regions.update();
        p.groups.weigh(p.regions);
      }
      double best = -std::numeric_limits<double>::infinity();
      for (const auto& [region, count] : selections)
        best = std::max(best, log_weight(p.regions, region, count, weights));
      const Index chosen = p.groups.select(p.regions);
      ASSERT_EQ(selections.count(chosen), 1U);
      const double got = log_weight(p.regions, chosen, selections[chosen], weights);
      ASSERT_NEAR(got, best, 1e-5 * (1 + std::abs(best))) << i;
      ++selections[chosen];
      ASSERT_EQ(p.groups.selections(chosen), selections[chosen]);
    }
  }
}

// Every operation in random turns; among few weights, so that there are ties.
TEST(Groups, ChoicesAreThoseOfAScanAfterAnySequence) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    constexpr std::uint32_t kVertices = 3000;
    Partition p(kVertices, random_room(seed));
    std::mt19937 random(seed);
    const bool ties = seed % 2 == 0;
    p.groups.clear({ties ? 1.0F : 8.0F, ties ? 0.5F : 0.85F, ties ? 1.0F : 0.01F}, kUnboundedSample);
    if (ties) {
      ASSERT_TRUE(p.regions.reset(Goal::disc({6, 6}, 4), 0.0F, 0.05F));  // many sources of the same weight
    }
    Reference reference(p.regions, p.groups);
    std::vector<Index> unused;
    for (Index v = kVertices; v > 1; --v) unused.push_back(v - 1);
    const Index start = p.region_with_a_cost();
    p.groups.insert(p.regions, start, detail::kRoot);
    reference.members[start] = {detail::kRoot};
    for (int i = 0; i < 6000; ++i) {
      const Index region = p.random_region(random);
      auto& members = reference.members[region];
      switch (random() % 8) {
        case 0:
        case 1:
        case 2:
          if (unused.empty()) break;
          p.groups.insert(p.regions, region, unused.back());
          members.push_back(unused.back());
          unused.pop_back();
          break;
        case 3: {
          const bool none = members.empty() || members.back() == detail::kRoot;
          ASSERT_EQ(p.groups.remove(region), none ? kNone : members.back());
          if (none) break;
          unused.push_back(members.back());
          members.pop_back();
          break;
        }
        case 4: {
          const Index besides = random() % 2 == 0 ? kNone : p.random_region(random);
          ASSERT_EQ(p.groups.lightest(besides), reference.lightest(besides)) << i;
          break;
        }
        case 5:
          if (random() % 10 != 0) break;
          p.regions.raise_edges(region, {50.0F, 0.7F});
          p.regions.repair();
          p.groups.weigh(p.regions);
          break;
        default: {
          const Index expected = reference.best();
          const std::uint32_t before = expected == kNone ? 0 : p.groups.selections(expected);
          ASSERT_EQ(p.groups.select(p.regions), expected) << i;
          if (expected != kNone) {
            ASSERT_EQ(p.groups.selections(expected), before + 1);
            if (random() % 4 == 0) {
              p.groups.unselect(p.regions, expected);
              ASSERT_EQ(p.groups.selections(expected), before);
            }
          }
        }
      }
      ASSERT_EQ(p.groups.size(region), members.size());
      ASSERT_EQ(p.members(region), std::vector<Index>(members.rbegin(), members.rend()));
    }
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
  for (Index i = 0; i < sources.size(); ++i) p.groups.insert(p.regions, sources[sources.size() - 1 - i], i + 1);
  EXPECT_EQ(p.groups.lightest(kNone), sources.back());
  EXPECT_EQ(p.groups.lightest(sources.back()), sources[sources.size() - 2]);
  for (const Index expected : sources) EXPECT_EQ(p.groups.select(p.regions), expected);
}

TEST(Groups, WithoutAFiniteCostNoneIsSelected) {
  Room room;
  room.bounds = {0, 0, 10, 4};
  room.boxes = {{4, 0, 5, 4}};
  room.goals = {{8, 0, 10, 4}};
  Partition p(10, room);
  EXPECT_EQ(p.groups.select(p.regions), kNone);
  Index cut_off = 0;
  while (p.regions.cost(cut_off) != kInfinity) ++cut_off;
  p.groups.insert(p.regions, cut_off, 0);
  EXPECT_EQ(p.groups.select(p.regions), kNone);
  EXPECT_EQ(p.groups.selections(cut_off), 0U);
}

// A goal that every region is part of: no region is nearer than another, and selections alone tell.
TEST(Groups, WhereAllLiesInTheGoalAllWeighTheSameAndTakeTurns) {
  Partition p(100);
  ASSERT_TRUE(p.regions.reset(Goal::disc({6, 6}, 1000), 0.0F, 0.05F));
  ASSERT_EQ(p.regions.largest_cost(), 0.0F);
  const detail::GroupWeights weights{8.0F, 0.9F, 0.01F};
  p.groups.clear(weights, kSample);
  for (Index r = 0; r < 10; ++r) p.groups.insert(p.regions, r, r);
  for (std::uint32_t turn = 0; turn < 3; ++turn) {
    for (Index r = 0; r < 10; ++r) {
      EXPECT_NEAR(static_cast<double>(p.groups.log_weight(p.regions, r)), 8 * std::log(1.01) + turn * std::log(0.9),
                  1e-5);
      EXPECT_EQ(p.groups.select(p.regions), r);
    }
  }
}

TEST(Groups, SelectionsAreCountedManyThousandTimesWithoutUnderflow) {
  Partition p(10);
  p.groups.clear({8.0F, 0.5F, 0.01F}, kSample);
  const Index a = p.region_with_a_cost(), goal = p.regions.goal_region();
  p.groups.insert(p.regions, a, 0);
  p.groups.insert(p.regions, goal, 1);
  for (int i = 0; i < 20'000; ++i) ASSERT_NE(p.groups.select(p.regions), kNone);
  // After so many, both are selected equally often, but for the head start of the goal.
  EXPECT_NEAR(static_cast<double>(p.groups.selections(a)), 10'000, 40);
  EXPECT_EQ(p.groups.selections(a) + p.groups.selections(goal), 20'000U);
}

TEST(Groups, SelectionsStayWhenTheMembersGo) {
  Partition p(10);
  const Index a = p.region_with_a_cost();
  p.groups.insert(p.regions, a, 1);
  for (int i = 0; i < 5; ++i) ASSERT_EQ(p.groups.select(p.regions), a);
  const float weight = p.groups.log_weight(p.regions, a);
  ASSERT_EQ(p.groups.remove(a), 1U);
  EXPECT_EQ(p.groups.size(a), 0U);
  EXPECT_EQ(p.groups.select(p.regions), kNone);
  EXPECT_EQ(p.groups.selections(a), 5U);
  p.groups.insert(p.regions, a, 2);
  EXPECT_EQ(p.groups.log_weight(p.regions, a), weight);
  EXPECT_EQ(p.groups.select(p.regions), a);
}

TEST(Groups, ASelectionThatIsTakenBackLeavesTheWeightAsItWas) {
  Partition p(10);
  const Index a = p.region_with_a_cost();
  p.groups.insert(p.regions, a, 1);
  const float weight = p.groups.log_weight(p.regions, a);
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(p.groups.select(p.regions), a);
    ASSERT_LT(p.groups.log_weight(p.regions, a), weight);
    p.groups.unselect(p.regions, a);
    ASSERT_EQ(p.groups.log_weight(p.regions, a), weight);
  }
  ASSERT_EQ(p.groups.select(p.regions), a);
  ASSERT_EQ(p.groups.remove(a), 1U);
  p.groups.unselect(p.regions, a);
  EXPECT_EQ(p.groups.select(p.regions), kNone);
}

TEST(Groups, TheRootIsNeverRemoved) {
  Partition p(10);
  const Index a = p.region_with_a_cost();
  p.groups.insert(p.regions, a, detail::kRoot);
  EXPECT_EQ(p.groups.lightest(kNone), kNone);
  EXPECT_EQ(p.groups.remove(a), kNone);
  p.groups.insert(p.regions, a, 5);
  EXPECT_EQ(p.groups.lightest(kNone), a);
  EXPECT_EQ(p.groups.lightest(a), kNone);
  EXPECT_EQ(p.groups.remove(a), 5U);
  EXPECT_EQ(p.groups.remove(a), kNone);
  EXPECT_EQ(p.groups.remove(a + 1), kNone);  // it has no members
  EXPECT_EQ(p.members(a), std::vector<Index>{detail::kRoot});
}

double chi_square(const std::vector<int>& counts, double expected) {
  double sum = 0;
  for (const int c : counts) sum += (c - expected) * (c - expected) / expected;
  return sum;
}

TEST(Groups, RandomVertexIsUniformInItsGroup) {
  for (const std::uint32_t size : {1U, 2U, 4U, 5U, 12U, 13U, 28U, 29U, 100U}) {
    Partition p(200);
    for (Index v = 0; v < size; ++v) {
      p.groups.insert(p.regions, 0, 2 * v);
      p.groups.insert(p.regions, 1, 2 * v + 1);  // interleaved with another group's
    }
    ASSERT_EQ(p.groups.size(0), size);
    detail::Random random(size);
    std::vector<int> counts(size);
    const int draws = 2000 * static_cast<int>(size);
    for (int i = 0; i < draws; ++i) {
      const Index v = p.groups.random_vertex(0, random);
      ASSERT_EQ(v % 2, 0U);
      ASSERT_LT(v / 2, size);
      ++counts[v / 2];
    }
    const double freedom = size - 1.0;
    EXPECT_LE(chi_square(counts, 2000.0), freedom + 5 * std::sqrt(2 * freedom) + 1e-9) << size;
  }
}

// A group's sample while `states` states reach its region one by one; vertex i is in slot i + 1, the root's is 0.
class Sample {
 public:
  Sample(Partition& partition, Index region) : p_(partition), region_(region) {}

  void reach(int state, detail::Random& random, Index root = kNone) {
    const detail::Groups::Place place = p_.groups.place(region_, random);
    if (!place.kept) return;
    if (place.replaced != kNone) {
      EXPECT_NE(place.replaced, detail::kRoot);
      held_[place.replaced] = state;
      return;
    }
    const Index vertex = root != kNone ? root : next_++;
    p_.groups.insert(p_.regions, region_, vertex);
    held_[vertex] = state;
  }
  const std::map<Index, int>& held() const { return held_; }

 private:
  Partition& p_;
  Index region_;
  Index next_ = 1;
  std::map<Index, int> held_;
};

TEST(Groups, EachStateThatReachedARegionIsAsLikelyInItsSample) {
  for (const auto& [sample, states] : {std::pair{1U, 5}, {4U, 20}, {8U, 9}, {8U, 60}}) {
    Partition p(20);
    detail::Random random(sample + 100);
    std::vector<int> counts(static_cast<std::size_t>(states));
    constexpr int kTrials = 20'000;
    for (int trial = 0; trial < kTrials; ++trial) {
      p.groups.clear(kWeights, sample);
      Sample drawn(p, 0);
      for (int i = 0; i < states; ++i) drawn.reach(i, random);
      ASSERT_EQ(p.groups.size(0), sample);
      ASSERT_EQ(p.groups.reached(0), static_cast<std::uint32_t>(states));
      for (const auto& [vertex, state] : drawn.held()) ++counts[static_cast<std::size_t>(state)];
    }
    // A trial draws `sample` of them without repetition: the counts vary less than of independent draws.
    const double share = static_cast<double>(sample) / states, freedom = states - 1.0;
    const double got = chi_square(counts, kTrials * share) / (1 - share) * freedom / states;
    EXPECT_LE(got, freedom + 5 * std::sqrt(2 * freedom)) << sample << " of " << states;
    EXPECT_GE(got, freedom - 5 * std::sqrt(2 * freedom)) << sample << " of " << states;
  }
}

TEST(Groups, TheRootIsNeverReplaced) {
  Partition p(20);
  detail::Random random(1);
  for (const std::uint32_t sample : {1U, 2U, 8U}) {
    p.groups.clear(kWeights, sample);
    Sample drawn(p, 0);
    drawn.reach(-1, random, detail::kRoot);
    for (int i = 0; i < 5000; ++i) drawn.reach(i, random);
    EXPECT_EQ(drawn.held().at(detail::kRoot), -1);
    EXPECT_EQ(p.members(0).back(), detail::kRoot);
    EXPECT_EQ(p.groups.size(0), sample);
  }
}

TEST(Groups, AnUnboundedSampleKeepsAllUpTo65535) {
  Partition p(70'000);
  p.groups.clear(kWeights, kUnboundedSample);
  detail::Random random(1);
  for (Index v = 0; v < 65'535; ++v) {
    const detail::Groups::Place place = p.groups.place(0, random);
    ASSERT_TRUE(place.kept);
    ASSERT_EQ(place.replaced, kNone);
    p.groups.insert(p.regions, 0, v);
  }
  for (int i = 0; i < 100; ++i) {
    const detail::Groups::Place place = p.groups.place(0, random);
    ASSERT_TRUE(!place.kept || place.replaced != kNone);
  }
  EXPECT_EQ(p.groups.size(0), 65'535U);
  EXPECT_EQ(p.groups.reached(0), 65'635U);
}

TEST(Groups, ForEachVertexVisitsEachOfItsGroupOnce) {
  Partition p(400);
  std::map<Index, std::multiset<Index>> expected;
  std::mt19937 random(1);
  for (Index v = 0; v < 400; ++v) {
    const Index region = below(random, 3);
    p.groups.insert(p.regions, region, v);
    expected[region].insert(v);
    for (const auto& [r, vertices] : expected) {
      const auto visited = p.members(r);
      ASSERT_EQ(std::multiset<Index>(visited.begin(), visited.end()), vertices);
    }
  }
}

TEST(Groups, EveryVertexCanBeDrawnFromAFullPool) {
  for (const std::uint32_t vertices : {1021U, 70'001U}) {  // of two and of four bytes
    Partition p(vertices);
    p.groups.clear(kWeights, kUnboundedSample);
    const Index groups = 7;
    for (Index v = 0; v < vertices; ++v) p.groups.insert(p.regions, v % groups, v);
    std::vector<bool> seen(vertices);
    for (Index group = 0; group < groups; ++group) {
      for (const Index v : p.members(group)) {
        ASSERT_EQ(v % groups, group);
        seen[v] = true;
      }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), true), vertices);
  }
}

TEST(Groups, ClearForgetsEverything) {
  Partition p(10);
  const Index a = p.region_with_a_cost();
  detail::Random random(1);
  p.groups.place(a, random);
  p.groups.insert(p.regions, a, 1);
  p.groups.select(p.regions);
  p.groups.clear(kWeights, kSample);
  EXPECT_EQ(p.groups.select(p.regions), kNone);
  EXPECT_EQ(p.groups.size(a), 0U);
  EXPECT_EQ(p.groups.reached(a), 0U);
  EXPECT_EQ(p.groups.selections(a), 0U);
  EXPECT_EQ(p.members(a), std::vector<Index>{});
}

}  // namespace
}  // namespace krait::test::groups_test
