// RRT: where connections begin, and that they go on. What holds for every planner is tested in planner_*_test.cpp.
#include "krait/search/rrt.hpp"

#include <algorithm>

#include "planner_fixture.hpp"

namespace krait::test {
namespace {

using OfUnicycle = RrtPlanner<Unicycle>;
using RrtBench = Bench<Unicycle, Rrt>;

Vec2 position(const OfUnicycle& planner, Index vertex) {
  return {planner.tree().state(vertex)[0], planner.tree().state(vertex)[1]};
}

TEST(RrtPlanner, ConnectionsBeginAtTheVertexNearestToTheirTarget) {
  RrtBench f(two_rooms(), small_unicycle());
  f.parameters.rrt.goal_share = 1.0F;
  ASSERT_TRUE(f.init().ok());
  const Vec2 center{11, 1};  // behind the wall: connections end at it
  const float start[] = {2, 1, 0};
  f.planner.start({start, Goal::disc(center, 1e-3F), 1});
  int begun = 0;
  for (int i = 0; i < 200; ++i) {
    const Index size = f.planner.tree().vertices();
    float least = kInfinity;
    for (Index v = 0; v < size; ++v) least = std::min(least, length(center - position(f.planner, v)));
    const Vec2 last = position(f.planner, size - 1);
    bool first = true;
    f.planner.advance(1, [&](const float* from, const float*) {
      const bool goes_on = from[0] == last.x && from[1] == last.y && size > 1;  // may be the last connection
      if (first && !goes_on) {
        ++begun;
        EXPECT_LE(length(center - Vec2{from[0], from[1]}), least + 3e-3F);
      }
      first = false;
    });
  }
  EXPECT_GT(begun, 0);
}

TEST(RrtPlanner, ConnectionsGoOnInTheNextIteration) {
  Room open;
  open.bounds = {0, 0, 40, 40};
  RrtBench f(open, small_unicycle());
  f.parameters.max_steps = 1;
  f.parameters.rrt.goal_share = 0.0F;
  ASSERT_TRUE(f.init().ok());
  const float start[] = {20, 20, 0};
  f.planner.start({start, Goal::disc({1, 1}, 1e-3F), 1});
  std::vector<float> last(3, kInfinity);
  std::uint32_t steps = 0, connections = 0;
  f.planner.advance(3000, [&](const float* from, const float* to) {
    ++steps;
    connections += std::equal(last.begin(), last.end(), from) ? 0U : 1U;
    last.assign(to, to + 3);
  });
  ASSERT_GT(steps, 1000U);
  EXPECT_EQ(f.planner.tree().vertices(), steps + 1);
  EXPECT_GT(steps / connections, 20U);
}

}  // namespace
}  // namespace krait::test
