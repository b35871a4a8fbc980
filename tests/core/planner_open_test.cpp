// SPDX-License-Identifier: Apache-2.0
// Expansions longer than max_steps: only in the open, and only by the planner that has them.
#include "planner_fixture.hpp"
#include "search/adaptive_search.hpp"

namespace krait::test::planner_open_test {
namespace {

constexpr float kStart[] = {5, 5, 0};
constexpr std::uint32_t kMaxSteps = 10;

// A hall of large triangles, and a unicycle that needs hundreds of steps to cross one.
Room hall() {
  Room room;
  room.bounds = {0, 0, 80, 80};
  room.spacing = 40;
  room.goals = {{74, 74, 78, 78}};
  return room;
}

struct HallBench : Bench<Unicycle> {
  explicit HallBench(std::uint32_t open_steps, const Room& room = hall()) : Bench<Unicycle>(room, small_unicycle()) {
    parameters.tuning.max_steps = kMaxSteps;
    parameters.tuning.open_steps = open_steps;
    EXPECT_TRUE(init().ok());
  }
};

// The expansions of a search, call by call. Each call that begins one selects a group; one that goes on selects none.
class Expansions {
 public:
  Expansions(HallBench& bench, std::uint64_t seed) : bench_(bench) {
    EXPECT_EQ(bench.planner.start({kStart, Goal::named(0), seed}), Status::searching);
  }

  // The positions of the current expansion after one more call, which is checked; `begun` says whether it is a new one.
  const std::vector<Vec2>& advance() {
    const std::uint32_t before = selections();
    std::vector<Vec2> more;
    (void)bench_.planner.advance(1, [&](const float*, const float* to) { more.push_back({to[0], to[1]}); });
    EXPECT_LE(more.size(), kMaxSteps);
    begun_ = selections() > before;
    not_counted_ = selections() < before;
    if (begun_) positions_.clear();
    positions_.insert(positions_.end(), more.begin(), more.end());
    return positions_;
  }
  bool searching() const {
    return bench_.planner.status() == Status::searching && !detail::opened(bench_.planner).driving();
  }
  bool begun() const { return begun_; }
  bool not_counted() const { return not_counted_; }  // whether the call took a selection back

 private:
  std::uint32_t selections() const {
    std::uint32_t sum = 0;
    for (Index region = 0; region < bench_.open.scene.triangle_count(); ++region) {
      sum += detail::opened(bench_.planner).groups().selections(region);
    }
    return sum;
  }

  HallBench& bench_;
  std::vector<Vec2> positions_;
  bool begun_ = false;
  bool not_counted_ = false;
};

// The most steps of an expansion over some searches.
std::size_t longest_expansion(std::uint32_t open_steps) {
  HallBench bench(open_steps);
  std::size_t most = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Expansions expansions(bench, seed);
    for (int i = 0; i < 200 && expansions.searching(); ++i) most = std::max(most, expansions.advance().size());
  }
  return most;
}

TEST(PlannerOpen, ExpansionsAreAsLongAsOpenStepsAllows) {
  EXPECT_EQ(longest_expansion(0), kMaxSteps);
  EXPECT_EQ(longest_expansion(kMaxSteps), kMaxSteps);
  EXPECT_EQ(longest_expansion(55), 55U);
  EXPECT_GT(longest_expansion(1000), 200U);
}

std::uint64_t hash_with(std::uint32_t open_steps) {
  Room room = hall();
  room.spacing = 8;
  HallBench bench(open_steps, room);
  bench.parameters.tuning.max_steps = 25;
  EXPECT_TRUE(bench.init().ok());
  EXPECT_EQ(bench.solve({kStart}), Status::solved);
  return bench.planner.statistics().hash;
}

TEST(PlannerOpen, AreNotThePapers) {
  EXPECT_EQ(Parameters::paper().tuning.open_steps, 0U);
  EXPECT_NE(hash_with(1000), hash_with(0));
}

// Past max_steps no step begins where two portals have been crossed, nor where the last one led away from the target.
TEST(PlannerOpen, WhatHasCrossedTwoPortalsIsNotInTheOpen) {
  Room room = hall();
  room.spacing = 4;
  HallBench bench(1000, room);
  int longer = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Expansions expansions(bench, seed);
    for (int i = 0; i < 40 && expansions.searching(); ++i) {
      const std::vector<Vec2>& positions = expansions.advance();
      if (positions.size() <= kMaxSteps) continue;
      ++longer;
      int crossed = 0;
      Index before = detail::locate(bench.open.scene, positions[0]);
      for (std::size_t step = 1; step + 1 < positions.size(); ++step) {
        const Index region = detail::locate(bench.open.scene, positions[step], before);
        crossed += region != before ? 1 : 0;
        before = region;
      }
      EXPECT_LE(crossed, 1);
    }
  }
  EXPECT_GT(longer, 20);
}

// A long expansion in the open that reaches its target does not count as a selection of its group.
TEST(PlannerOpen, ALongWayThatReachesItsTargetIsNoSelection) {
  HallBench bench(1000);
  int not_counted = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Expansions expansions(bench, seed);
    bool last_went_on = false;
    while (expansions.searching()) {
      const std::size_t steps = expansions.advance().size();
      EXPECT_TRUE(expansions.begun() || last_went_on);
      if (expansions.not_counted()) {
        EXPECT_GT(steps, kMaxSteps);
        ++not_counted;
      }
      last_went_on = steps % kMaxSteps == 0;
    }
  }
  EXPECT_GT(not_counted, 5);
}

// However long an expansion is, it counts once for the tries of a search.
TEST(PlannerOpen, ALongWayIsOneExpansionOfATry) {
  constexpr std::uint32_t kUnit = 5;
  HallBench bench(1000);
  bench.parameters.tuning.restart_unit = 10 * kUnit;  // of which a try lasts a tenth: the way is short
  ASSERT_TRUE(bench.init().ok());
  Expansions expansions(bench, 1);
  std::uint32_t begun = 0;
  while (expansions.searching() && bench.planner.statistics().restarts == 0) {
    expansions.advance();
    begun += expansions.begun() ? 1 : 0;
  }
  EXPECT_EQ(begun, kUnit);
  EXPECT_GT(bench.planner.statistics().iterations, 3 * kUnit);
}

}  // namespace
}  // namespace krait::test::planner_open_test
