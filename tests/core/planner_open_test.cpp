// Expansions longer than max_steps: only in the open, and only by the planner that has them.
#include "planner_fixture.hpp"

namespace krait::test {
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

template <class P>
struct HallBench : Bench<Unicycle, P> {
  explicit HallBench(std::uint32_t open_steps, const Room& room = hall()) : Bench<Unicycle, P>(room, small_unicycle()) {
    this->parameters.max_steps = kMaxSteps;
    this->parameters.open_steps = open_steps;
    EXPECT_TRUE(this->init().ok());
  }

  // The states after which the steps of one more expansion end; none when the search has ended.
  std::vector<Vec2> expand() {
    std::vector<Vec2> positions;
    this->planner.advance(1, [&](const float*, const float* to) { positions.push_back({to[0], to[1]}); });
    return positions;
  }
};

// The most steps of an expansion over some searches.
template <class P>
std::size_t longest_expansion(std::uint32_t open_steps) {
  HallBench<P> bench(open_steps);
  std::size_t most = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    bench.planner.start({kStart, Goal::named(0), seed});
    for (int i = 0; i < 100 && bench.planner.status() == Status::searching; ++i) {
      most = std::max(most, bench.expand().size());
    }
  }
  return most;
}

TEST(PlannerOpen, ExpansionsAreAsLongAsOpenStepsAllows) {
  EXPECT_EQ(longest_expansion<AdaptivePlanner>(0), kMaxSteps);
  EXPECT_EQ(longest_expansion<AdaptivePlanner>(kMaxSteps), kMaxSteps);
  EXPECT_EQ(longest_expansion<AdaptivePlanner>(50), 50U);
  EXPECT_GT(longest_expansion<AdaptivePlanner>(1000), 200U);
}

TEST(PlannerOpen, AreNotThePapersNorOfOtherPlanners) {
  EXPECT_EQ(Parameters::paper().open_steps, 0U);
  EXPECT_EQ(longest_expansion<Prior>(1000), kMaxSteps);
  EXPECT_EQ(longest_expansion<Rrt>(1000), kMaxSteps);
}

// Past max_steps no step begins where two portals have been crossed.
TEST(PlannerOpen, WhatHasCrossedTwoPortalsIsNotInTheOpen) {
  Room room = hall();
  room.spacing = 4;
  HallBench<AdaptivePlanner> bench(1000, room);
  int longer = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    bench.planner.start({kStart, Goal::named(0), seed});
    for (int i = 0; i < 20; ++i) {
      const std::vector<Vec2> positions = bench.expand();
      if (positions.size() <= kMaxSteps) continue;
      ++longer;
      int crossed = 0;
      Index before = locate(bench.open.scene, positions[0]);
      for (std::size_t step = 1; step + 1 < positions.size(); ++step) {
        const Index region = locate(bench.open.scene, positions[step], before);
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
  HallBench<AdaptivePlanner> bench(1000);
  int not_counted = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    bench.planner.start({kStart, Goal::named(0), seed});
    std::uint32_t selections = 0;
    while (bench.planner.status() == Status::searching) {
      const std::size_t steps = bench.expand().size();
      std::uint32_t now = 0;
      for (Index region = 0; region < bench.open.scene.triangle_count(); ++region) {
        now += bench.planner.guide().selections(region);
      }
      if (now == selections) {
        EXPECT_GT(steps, kMaxSteps);
        ++not_counted;
      } else {
        EXPECT_EQ(now, selections + 1);
      }
      selections = now;
    }
  }
  EXPECT_GT(not_counted, 10);
}

}  // namespace
}  // namespace krait::test
