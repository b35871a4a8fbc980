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
