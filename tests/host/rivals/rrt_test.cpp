// SPDX-License-Identifier: Apache-2.0
// RRT: where connections begin, and that they go on. What holds for every planner is tested in planner_*_test.cpp.

#include <algorithm>

#include "rivals.hpp"

namespace krait::test::rrt_test {
namespace {

using OfUnicycle = RrtPlanner;
using RrtBench = Bench<Unicycle, RrtPlanner>;
using rivals::RrtParameters;

Vec2 position(const OfUnicycle& planner, Index vertex) {
  return {planner.tree().state(vertex)[0], planner.tree().state(vertex)[1]};
}

TEST(RrtPlanner, ConnectionsBeginAtTheVertexNearestToTheirTarget) {
  RrtBench f(two_rooms(), small_unicycle(), RrtParameters{1.0F});
  ASSERT_TRUE(f.init().ok());
  const Vec2 center{11, 1};  // behind the wall: connections end at it
  const float start[] = {2, 1, 0};
  EXPECT_EQ(f.planner.start({start, Goal::disc(center, 1e-3F), 1}), Status::searching);
  int begun = 0;
  for (int i = 0; i < 200; ++i) {
    const Index size = f.planner.tree().vertices();
    float least = kInfinity;
    for (Index v = 0; v < size; ++v) least = std::min(least, length(center - position(f.planner, v)));
    const Vec2 last = position(f.planner, size - 1);
    bool first = true;
    auto watch = [&](const float* from, const float*) {
      const bool goes_on = from[0] == last.x && from[1] == last.y && size > 1;  // may be the last connection
      if (first && !goes_on) {
        ++begun;
        EXPECT_LE(length(center - Vec2{from[0], from[1]}), least + 3e-3F);
      }
      first = false;
    };
    (void)f.planner.advance(1, watch);
  }
  EXPECT_GT(begun, 0);
}

TEST(RrtPlanner, ConnectionsGoOnInTheNextIteration) {
  Room open;
  open.bounds = {0, 0, 40, 40};
  RrtBench f(open, small_unicycle(), RrtParameters{0.0F});
  f.parameters.tuning.max_steps = 1;
  ASSERT_TRUE(f.init().ok());
  const float start[] = {20, 20, 0};
  EXPECT_EQ(f.planner.start({start, Goal::disc({1, 1}, 1e-3F), 1}), Status::searching);
  std::vector<float> last(3, kInfinity);
  std::uint32_t steps = 0, connections = 0;
  auto watch = [&](const float* from, const float* to) {
    ++steps;
    connections += std::equal(last.begin(), last.end(), from) ? 0U : 1U;
    last.assign(to, to + 3);
  };
  (void)f.planner.advance(3000, watch);
  ASSERT_GT(steps, 1000U);
  EXPECT_EQ(f.planner.tree().vertices(), steps + 1);
  EXPECT_GT(steps / connections, 20U);
}

// What an expansion of a connection began with and where it has got to.
struct Connection {
  Vec2 target{}, from{}, to{};
  int expansions = 0;  // with this target
  int in_vain = 0;     // of those that were gone on from, how many came no closer
};

struct ConnectionWatch {
  const OfUnicycle* planner;
  Connection* now;

  void expands(Index vertex, const Target& target) const {
    const bool goes_on = now->expansions > 0 && target.point.x == now->target.x && target.point.y == now->target.y;
    const bool closer = length(now->target - now->to) < length(now->target - now->from) + 1e-3F;  // targets are rounded
    now->in_vain += goes_on && !closer ? 1 : 0;
    now->expansions = goes_on ? now->expansions + 1 : 1;
    now->target = target.point;
    now->from = now->to = position(*planner, vertex);
  }
  void operator()(const float*, const float* to) const { now->to = {to[0], to[1]}; }
};

// A robot that turns about its target would go on for ever.
TEST(RrtPlanner, ConnectionsEndThatComeNoCloser) {
  Room open;
  open.bounds = {0, 0, 20, 20};
  RrtBench f(open, small_unicycle(), RrtParameters{0.0F});
  f.parameters.tuning.max_steps = 3;
  f.parameters.tuning.near_radius = 0;
  ASSERT_TRUE(f.init().ok());
  const float start[] = {10, 10, 0};
  EXPECT_EQ(f.planner.start({start, Goal::disc({1, 1}, 1e-3F), 1}), Status::searching);
  Connection now;
  const ConnectionWatch watch{&f.planner, &now};
  int longest = 0;
  for (int i = 0; i < 3000; ++i) {
    (void)f.planner.advance(1, watch);
    longest = std::max(longest, now.expansions);
  }
  EXPECT_GT(longest, 10);
  EXPECT_EQ(now.in_vain, 0);
}

}  // namespace
}  // namespace krait::test::rrt_test
