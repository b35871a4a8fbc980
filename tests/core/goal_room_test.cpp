// SPDX-License-Identifier: Apache-2.0
// The room in a goal against a dense grid of its points, in double precision.
#include "collision/goal_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene_builder.hpp"

namespace krait::test::goal_room_test {
namespace {

// A room and the outlines of its boxes.
struct Walls {
  explicit Walls(const Room& room) : bounds(room.bounds) {
    for (const Rect& box : room.boxes) {
      const std::vector<Vec2> vertices = corners(box);
      boxes.push_back(ring({vertices.data(), 4}));
    }
  }
  double clearance(Point p) const {
    double least = std::min({p.x - bounds.x0, bounds.x1 - p.x, p.y - bounds.y0, bounds.y1 - p.y});
    for (const Ring& box : boxes) least = std::min(least, distance_to_convex(p, box));
    return std::max(least, 0.0);
  }
  Rect bounds;
  std::vector<Ring> boxes;
};

// The most clearance of a grid of points in a disc.
double roomiest(const Walls& walls, Point center, double radius) {
  constexpr int kSteps = 20;
  double most = 0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    for (int j = -kSteps; j <= kSteps; ++j) {
      const Point p{center.x + radius * i / kSteps, center.y + radius * j / kSteps};
      if (std::hypot(p.x - center.x, p.y - center.y) <= radius) most = std::max(most, walls.clearance(p));
    }
  }
  return most;
}

detail::GoalRoom room_of(const OpenScene& open, const Goal& goal, float reach, double enough) {
  return goal_room(open.scene, detail::Obstacles(open.scene, 0.0F), goal, reach, static_cast<float>(enough));
}

TEST(GoalRoom, IsEnoughWhereAPointHasItAndNotWhereNoneHas) {
  std::mt19937 random(1);
  int enough = 0, cramped = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const Room room = random_room(seed, 12, 25);
    const OpenScene open(room);
    const Walls walls(room);
    for (int i = 0; i < 16; ++i) {
      const Vec2 center{uniform_float(random, 0, 12), uniform_float(random, 0, 12)};
      const float radius = uniform_float(random, 0.05, 0.6);
      const float reach = i % 2 == 0 ? 0.0F : 0.3F;
      const double most = roomiest(walls, point(center), static_cast<double>(radius + reach));
      const Goal goal = Goal::disc(center, radius);
      const double step = 1.5 * static_cast<double>(radius + reach) / 20;  // between the grid's points
      EXPECT_TRUE(room_of(open, goal, reach, most - 1e-3).enough) << seed;
      const detail::GoalRoom beyond = room_of(open, goal, reach, most + 0.06 + step);
      EXPECT_FALSE(beyond.enough) << seed;
      EXPECT_NEAR(static_cast<double>(beyond.found), most, 0.06 + step) << seed;
      if (beyond.found > 0.0F) {
        EXPECT_NEAR(walls.clearance(point(beyond.at)), static_cast<double>(beyond.found), 1e-3) << seed;
        EXPECT_TRUE(goal.near(open.scene, beyond.at, reach)) << seed;
      }
      (most > 0.3 ? enough : cramped) += 1;
    }
  }
  EXPECT_GT(enough, 50);
  EXPECT_GT(cramped, 10);
}

TEST(GoalRoom, OfAPolygonCountsOnlyPointsNearIt) {
  Room room;
  room.goals = {{0, 0, 0.5, 10}};  // a strip along the bounds
  const OpenScene open(room);
  EXPECT_TRUE(room_of(open, Goal::named(0), 0.0F, 0.45).enough);
  EXPECT_FALSE(room_of(open, Goal::named(0), 0.0F, 1.2).enough);
  EXPECT_TRUE(room_of(open, Goal::named(0), 0.8F, 1.2).enough);
}

}  // namespace
}  // namespace krait::test::goal_room_test
