// SPDX-License-Identifier: Apache-2.0
// What callers must see to is checked where a build asks for it, as the builds with sanitizers do.
#include <gtest/gtest.h>

#include "base/arena.hpp"
#include "krait/krait.hpp"
#include "plan/motion_tree.hpp"
#include "planner_fixture.hpp"

namespace krait::test {
namespace {

class Contracts : public ::testing::Test {
 protected:
  void SetUp() override {
#ifndef KRAIT_ASSERT_HEADER
    GTEST_SKIP() << "contracts are not checked in this build";
#endif
  }
};

TEST_F(Contracts, OfAScenesIndices) {
  const OpenScene open(two_rooms());
  const Scene& scene = open.scene;
  EXPECT_DEATH((void)scene.start(scene.start_count()), "broken contract: start < start_count");
  EXPECT_DEATH((void)scene.goal_name(scene.goal_count()), "broken contract: goal < goal_count");
  EXPECT_DEATH((void)scene.goal_polygon(kNone), "broken contract: goal < goal_count");
  EXPECT_DEATH((void)scene.corner(scene.triangle_count(), 0), "broken contract: triangle < triangle_count");
  EXPECT_DEATH((void)scene.neighbor(0, 3), "broken contract: .*i < 3");
  EXPECT_DEATH((void)scene.piece(scene.piece_count()), "broken contract: piece < piece_count");
}

TEST_F(Contracts, OfAScenesCellsAndBuckets) {
  const OpenScene open(two_rooms());
  const Scene& scene = open.scene;
  const CellGrid& cells = scene.buckets();
  const std::size_t last = cells.index({cells.columns - 1, cells.rows - 1});
  EXPECT_DEATH((void)cells.index({cells.columns, 0}), "broken contract: .*c.column < columns");
  EXPECT_DEATH((void)cells.index({0, -1}), "broken contract: .*c.row >= 0");
  const std::uint32_t triangles = scene.bucket_triangles_begin(last + 1);
  const std::uint32_t pieces = scene.bucket_pieces_begin(last + 1);
  EXPECT_DEATH((void)scene.bucket_triangles_begin(last + 2), "broken contract: bucket <= bucket_count");
  EXPECT_DEATH((void)scene.bucket_pieces_begin(last + 2), "broken contract: bucket <= bucket_count");
  EXPECT_DEATH((void)scene.bucket_triangle(triangles), "broken contract: i < header_.bucket_triangles");
  EXPECT_DEATH((void)scene.bucket_piece(pieces), "broken contract: i < header_.bucket_pieces");
  EXPECT_DEATH((void)IndexArray()[0], "broken contract: data_ != nullptr");
}

TEST_F(Contracts, OfAPolygonsVertices) {
  const Vec2 corners[] = {{0, 0}, {1, 0}, {0, 1}};
  const Polygon polygon{corners, 3};
  EXPECT_DEATH((void)polygon[3], "broken contract: i >= 0 && i < count");
  EXPECT_DEATH((void)polygon[-1], "broken contract: i >= 0 && i < count");
  EXPECT_DEATH((void)bounding_box({}), "broken contract: i >= 0 && i < count");
}

TEST_F(Contracts, OfAGoalThatIsNotValid) {
  const OpenScene open(two_rooms());
  const Scene& scene = open.scene;
  const Goal goal = Goal::named(scene.goal_count());
  const Goal disc = Goal::disc({1, 1}, -1.0F);
  EXPECT_DEATH((void)goal.contains(scene, {1, 1}, 0.0F), "broken contract: valid");
  EXPECT_DEATH((void)goal.box(scene), "broken contract: valid");
  EXPECT_DEATH((void)disc.covers(scene, 0), "broken contract: valid");
  EXPECT_DEATH((void)disc.may_reach(scene, 0, 1.0F, {}), "broken contract: valid");
  EXPECT_DEATH((void)disc.near(scene, {1, 1}, 1.0F), "broken contract: valid");
  EXPECT_DEATH((void)disc.deepest(scene), "broken contract: valid");
}

TEST_F(Contracts, OfARobotThatRefersToNone) {
  const Robot none;
  EXPECT_FALSE(none.sizes_valid());
  EXPECT_TRUE(none.sound() && none.exact());
  EXPECT_DEATH((void)none.reversible(), "broken contract: functions_ != nullptr");
  EXPECT_DEATH((void)none.leads(), "broken contract: functions_ != nullptr");
  EXPECT_DEATH((void)none.fastest_rate(0.1F), "broken contract: functions_ != nullptr");
}

TEST_F(Contracts, OfARobotsBodies) {
  ChainParameters parameters;
  parameters.trailers = 2;
  Truck truck(parameters);
  EXPECT_DEATH((void)Robot(truck).body(3), "broken contract: k >= 0 && k < body_count_");
  EXPECT_DEATH((void)truck.body(Truck::kMaxBodies), "broken contract: k >= 0 && k < kMaxBodies");
  EXPECT_DEATH(truck.set_body(-1, {}), "broken contract: k >= 0 && k < kMaxBodies");
}

TEST_F(Contracts, OfAPidControllersTime) {
  Pid pid;
  EXPECT_DEATH((void)pid({1, 0, 0}, 1.0F, 0.0F), "broken contract: dt > 0");
}

TEST_F(Contracts, OfACursorAtItsEnd) {
  Bench<Unicycle> bench(two_rooms(), small_unicycle());
  ASSERT_TRUE(bench.init().ok());
  const float start[] = {2, 6, 0};
  ASSERT_EQ(bench.solve({start}), Status::solved);
  PlanCursor at = bench.planner.plan().cursor();
  while (!at.done()) at.advance();
  EXPECT_DEATH(at.advance(), "broken contract: !done");
  EXPECT_DEATH((void)at.control(), "broken contract: !done");
  EXPECT_DEATH((void)PlanCursor().next(), "broken contract: !done");
}

TEST_F(Contracts, OfAFullTree) {
  alignas(detail::Arena::kAlignment) std::byte block[256];
  detail::Arena arena(block, sizeof block);
  detail::MotionTree tree;
  tree.allocate(arena, 2, 2, 2);
  ASSERT_TRUE(arena.fits());
  tree.reset({{0, 0}, {1, 1}}, 0);
  const float state[] = {0, 0};
  (void)tree.add({}, state);
  EXPECT_DEATH(tree.remove(1), "broken contract: vertex < vertex_high_");
  const Index expansion = tree.begin_expansion({}, {});
  (void)tree.add({expansion, 1}, state);
  EXPECT_DEATH((void)tree.add({expansion, 2}, state), "broken contract: !vertices_full");
  (void)tree.begin_expansion({}, {});
  EXPECT_DEATH((void)tree.begin_expansion({}, {}), "broken contract: expansions_ < expansion_capacity_");
  EXPECT_DEATH((void)tree.state(2), "broken contract: vertex < vertex_high_");
}

TEST_F(Contracts, OfAnArenaThatIsMisaligned) {
  alignas(detail::Arena::kAlignment) std::byte block[64];
  EXPECT_DEATH((void)detail::Arena(block + 4, 32), "broken contract: .*kAlignment == 0");
}

}  // namespace
}  // namespace krait::test
