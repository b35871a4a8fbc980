// RRT: where connections begin, and that they go on. What holds for every planner is tested in planner_*_test.cpp.
#include "krait/search/rrt.hpp"

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
    const Index size = f.planner.tree().size();
    f.planner.advance(1);
    if (f.planner.tree().size() == size) continue;
    const Index parent = f.planner.tree().parent(size);
    if (parent + 1 == size && size > 1) continue;  // may be the last connection, going on
    float least = kInfinity;
    for (Index v = 0; v < size; ++v) least = std::min(least, length(center - position(f.planner, v)));
    ++begun;
    EXPECT_LE(length(center - position(f.planner, parent)), least + 3e-3F);
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
  f.planner.advance(3000);
  const MotionTree& tree = f.planner.tree();
  ASSERT_GT(tree.size(), 1000U);
  std::uint32_t connections = 1;
  for (Index v = 2; v < tree.size(); ++v) connections += tree.parent(v) != v - 1 ? 1U : 0U;
  EXPECT_GT(tree.size() / connections, 20U);
}

}  // namespace
}  // namespace krait::test
