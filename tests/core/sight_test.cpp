// SPDX-License-Identifier: Apache-2.0
// Discs and their lines against brute force over all pieces in double precision.
#include "collision/sight.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "convex.hpp"
#include "scene_builder.hpp"

namespace krait::test::sight_test {
namespace {

constexpr float kStep = 0.25F;

Room crowded(unsigned seed) {
  std::mt19937 random(seed);
  Room room = random_room(seed, 12, 5);
  for (int i = 0; i < 8; ++i) {
    room.loose_pieces.push_back(random_convex(random, {uniform(random, 1, 11), uniform(random, 1, 11)}, 1));
  }
  return room;
}

double true_distance(const Scene& scene, Point p) {
  const Box b = scene.bounds();
  double least = std::min({p.x - point(b.min).x, point(b.max).x - p.x, p.y - point(b.min).y, point(b.max).y - p.y});
  for (Index i = 0; i < scene.piece_count(); ++i) least = std::min(least, distance_to_convex(p, ring(scene.piece(i))));
  return least;
}

TEST(Sight, ADiscIsFreeWhereNoPieceAndNoBoundIsWithinItsRadius) {
  constexpr double kRounding = 1e-5;
  int by_grid = 0, by_pieces = 0, blocked = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const OpenScene open(crowded(seed));
    std::mt19937 random(seed);
    for (int i = 0; i < 3000; ++i) {
      const float radius = i % 10 == 0 ? 0.0F : uniform_float(random, 0, 1);
      const Vec2 at{uniform_float(random, -0.5, 12.5), uniform_float(random, -0.5, 12.5)};
      const double room = true_distance(open.scene, point(at)) - static_cast<double>(radius);
      if (std::abs(room) < kRounding) continue;
      const float slack = detail::Sight::in(open.scene, radius, kStep).slack(at);
      ASSERT_EQ(slack >= 0.0F, room > 0.0) << at.x << " " << at.y << " " << radius;
      ASSERT_LE(static_cast<double>(slack), std::max(room, 0.0) + kRounding);
      (slack < 0.0F ? blocked : slack > 0.0F ? by_grid : by_pieces) += 1;
    }
  }
  EXPECT_GT(by_grid, 1000);
  EXPECT_GT(by_pieces, 1000);
  EXPECT_GT(blocked, 1000);
}

TEST(Sight, NothingIsFreeWhereNoPointIs) {
  const OpenScene open(crowded(1));
  const auto sight = detail::Sight::in(open.scene, 0.1F, kStep);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Vec2 at : {Vec2{nan, 1}, Vec2{1, nan}, Vec2{kInfinity, 1}, Vec2{1, -kInfinity}, Vec2{1e30F, 1e30F}}) {
    EXPECT_LT(sight.slack(at), 0.0F);
  }
}

// A line is in sight when the discs on it are free; whoever says so has looked at places a step apart.
TEST(Sight, ALineIsFreeWhereAllItsDiscsAre) {
  int free = 0, blocked = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const OpenScene open(crowded(seed));
    std::mt19937 random(seed);
    for (int i = 0; i < 500; ++i) {
      const float radius = uniform_float(random, 0.05, 0.5);
      const Vec2 a{uniform_float(random, 0, 12), uniform_float(random, 0, 12)};
      const Vec2 b{uniform_float(random, 0, 12), uniform_float(random, 0, 12)};
      const double far = static_cast<double>(length(b - a));
      double least = kInfinity;  // room of a disc past the first step
      double bare = 0;           // the longest piece of the way without a free disc
      double begun = -1;
      for (double gone = static_cast<double>(kStep) + 1e-4; gone < far - 1e-4; gone += 0.01) {
        const double share = gone / far;
        const Point at{point(a).x + share * (point(b).x - point(a).x), point(a).y + share * (point(b).y - point(a).y)};
        const double room = true_distance(open.scene, at) - static_cast<double>(radius);
        least = std::min(least, room);
        if (room > 0) begun = -1;
        if (room <= 0 && begun < 0) begun = gone;
        if (begun >= 0) bare = std::max(bare, gone - begun);
      }
      const bool seen = detail::Sight::in(open.scene, radius, kStep).line_free(a, b);
      ASSERT_TRUE(seen || least < 1e-3) << seed << " " << i;
      ASSERT_TRUE(!seen || bare < static_cast<double>(kStep) + 0.02) << seed << " " << i;
      (seen ? free : blocked) += 1;
    }
  }
  EXPECT_GT(free, 200);
  EXPECT_GT(blocked, 200);
}

// Along a wall, where the grid tells nothing, the number of looks ends before the line does.
TEST(Sight, ALineIsNotFreeWhereLooksDoNotReachItsEnd) {
  Room room;
  room.bounds = {0, 0, 120, 4};
  room.spacing = 20;
  room.clearance_cell = 1;
  const OpenScene open(room);
  const auto sight = detail::Sight::in(open.scene, 0.3F, kStep);
  const float reach = kStep * static_cast<float>(detail::Sight::kMostLooks);
  EXPECT_TRUE(sight.line_free({1, 0.4F}, {0.9F * reach, 0.4F}));
  EXPECT_FALSE(sight.line_free({1, 0.4F}, {1.2F * reach + 1, 0.4F}));
}

TEST(Sight, ALineThatIsNoLongerThanAStepIsFree) {
  const OpenScene open(crowded(1));
  const auto sight = detail::Sight::in(open.scene, 100.0F, kStep);
  EXPECT_TRUE(sight.line_free({5, 5}, {5, 5}));
  EXPECT_TRUE(sight.line_free({5, 5}, {5, 5.0F + kStep}));
  EXPECT_FALSE(sight.line_free({5, 5}, {5, 5.1F + kStep}));
}

}  // namespace
}  // namespace krait::test::sight_test
