// SPDX-License-Identifier: Apache-2.0
// How corners are rounded and routes are changed.
#include "improve/corners.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace krait::test::corners_test {
namespace {

const detail::Turns kTurns = {{0.5F, 0.9F, 1.4F, 2.1F, 3.0F, 4.2F}, 0.8F};

TEST(Corners, NormalNumbersHaveTheirMeanAndDeviation) {
  detail::Random random(1);
  double sum = 0, squares = 0;
  constexpr int kCount = 20'000;
  for (int i = 0; i < kCount; ++i) {
    const double x = static_cast<double>(normal(random));
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kCount, 0, 0.03);
  EXPECT_NEAR(squares / kCount, 1, 0.04);
}

TEST(Corners, AreRoundedOutwardByOneOfTheTurns) {
  detail::Random random(1);
  int outward = 0, inward = 0;
  for (int i = 0; i < 500; ++i) {
    detail::Via via{{4, 0}, 0, 0, 0};
    detail::round_corner({0, 0}, via, {4, 5}, kTurns, random);  // to the left: outward is right and down
    EXPECT_GE(via.look, 0.8F * kTurns.unit);
    EXPECT_LE(via.look, 4.5F * kTurns.unit);
    EXPECT_NE(std::find(std::begin(detail::Turns::kShare), std::end(detail::Turns::kShare), via.turn),
              std::end(detail::Turns::kShare));
    EXPECT_NEAR(via.at.x - 4, -via.at.y, 1e-5F);  // on the bisector
    EXPECT_LE(length(via.at - Vec2{4, 0}), 1.1F * 1.8F * kTurns.unit);
    (via.at.x > 4 ? outward : inward) += 1;
  }
  EXPECT_GT(outward, 4 * inward);
  EXPECT_GT(inward, 20);
}

TEST(Corners, MoveOutwardForTrailersByTheLengthOfThose) {
  constexpr int kCount = 500;
  constexpr float kTrail = 2.0F;
  detail::Turns trailing = kTurns;
  trailing.trail = kTrail;
  const auto mean_way = [](const detail::Turns& turns) {
    detail::Random random(1);
    double sum = 0;
    for (int i = 0; i < kCount; ++i) {
      detail::Via via{{4, 0}, 0, 0, 0};
      detail::round_corner({0, 0}, via, {4, 5}, turns, random);
      EXPECT_NEAR(via.at.x - 4, -via.at.y, 1e-5F);
      sum += static_cast<double>(via.at.x - 4);
    }
    return sum / kCount;
  };
  EXPECT_NEAR(mean_way(trailing) - mean_way(kTurns), 0.25 * static_cast<double>(kTrail), 0.05);
}

TEST(Corners, StraightLinesAndViasAtOnePlaceStayWhereTheyAre) {
  detail::Random random(1);
  for (const Vec2 after : {Vec2{8, 0}, Vec2{4, 0}}) {
    detail::Via via{{4, 0}, 0, 0, 0};
    detail::round_corner({0, 0}, via, after, kTurns, random);
    EXPECT_EQ(via.at.x, 4.0F);
    EXPECT_EQ(via.at.y, 0.0F);
    EXPECT_GT(via.look, 0.0F);
    EXPECT_TRUE(finite(via.look));
  }
}

TEST(Corners, ChangesKeepTheFirstViaAndTheRest) {
  std::vector<std::uint64_t> block(400);
  detail::Arena arena(block.data(), block.size() * 8);
  detail::Route route, changed;
  route.allocate(arena, 8);
  changed.allocate(arena, 8);
  for (const Vec2 at : {Vec2{0, 0}, Vec2{4, 0}, Vec2{4, 4}, Vec2{8, 4}, Vec2{8, 8}}) route.add({at, 1, 1, 0});
  route.measure();
  detail::Random random(1);
  int longer = 0, shorter = 0, moved = 0, driven_otherwise = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto via = static_cast<std::uint32_t>(1 + i % 4);
    changed.copy(route);
    change(changed, via, kTurns, random);
    EXPECT_EQ(length(changed[0].at), 0.0F);
    for (std::uint32_t k = 1; k < via; ++k) EXPECT_EQ(length(changed[k].at - route[k].at), 0.0F);
    longer += changed.count() > route.count();
    shorter += changed.count() < route.count();
    if (changed.count() != route.count()) continue;
    moved += length(changed[via].at - route[via].at) > 0;
    driven_otherwise += changed[via].look != 1;
    EXPECT_TRUE(finite(changed[via].at));
  }
  EXPECT_GT(longer, 100);
  EXPECT_GT(shorter, 50);
  EXPECT_GT(moved, 800);
  EXPECT_GT(driven_otherwise, 400);
}

}  // namespace
}  // namespace krait::test::corners_test
