// SPDX-License-Identifier: Apache-2.0
// When a position is in the goal, and how deep.
#include "krait/goal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/grid_point.hpp"
#include "scene_builder.hpp"

namespace krait::test::goal_test {
namespace {

SceneData with_polygon(const std::vector<Vec2>& goal) {
  Room room;
  room.goals = {{1, 1, 2, 2}};
  SceneData data = data_of(room);
  data.goals[0] = goal;
  return data;
}

struct Opened {
  explicit Opened(const SceneData& data) : bytes(data.bytes()) {
    EXPECT_TRUE(Scene::open(bytes.data(), bytes.size(), scene).ok());
  }
  SceneBytes bytes;
  Scene scene;
};

double border_distance(Point p, const Ring& polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    least = std::min(least, distance_to_segment(p, polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  return least;
}

// By the sum of the angles under which the sides are seen.
bool winds_around(Point p, const Ring& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
    sum += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  return std::abs(sum) > 3;
}

void expect_membership(const std::vector<Vec2>& polygon) {
  const Opened opened(with_polygon(polygon));
  const Ring expected = ring({polygon.data(), static_cast<int>(polygon.size())});
  std::mt19937 random(1);
  int inside = 0;
  for (int i = 0; i < 50'000; ++i) {
    const Vec2 p{uniform_float(random, 0, 10), uniform_float(random, 0, 10)};
    const double border = border_distance(point(p), expected);
    for (const float depth : {-0.4F, 0.0F, 0.03F, 0.5F}) {
      if (std::abs(border - static_cast<double>(std::fabs(depth))) < 1e-5) continue;
      const double from_border = winds_around(point(p), expected) ? border : -border;
      const bool deep = from_border > static_cast<double>(depth);
      ASSERT_EQ(Goal::named(0).contains(opened.scene, p, depth), deep) << p.x << " " << p.y << " " << depth;
      inside += deep ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(Goal, ContainsByPositionAndDepthInAConvexPolygon) { expect_membership({{2, 2}, {8, 3}, {7, 8}, {3, 7}}); }

TEST(Goal, ContainsByPositionAndDepthInAPolygonThatIsNotConvex) {
  expect_membership({{1, 1}, {9, 1}, {9, 9}, {7, 9}, {7, 3}, {3, 3}, {3, 9}, {1, 9}});
}

TEST(Goal, DiscContainsByDistance) {
  const OpenScene open{Room{}};
  const Goal disc = Goal::disc({5, 5}, 2);
  EXPECT_TRUE(disc.contains(open.scene, {6.9F, 5}, 0));
  EXPECT_FALSE(disc.contains(open.scene, {6.9F, 5}, 0.2F));
  EXPECT_FALSE(disc.contains(open.scene, {7.1F, 5}, 0));
  EXPECT_TRUE(disc.contains(open.scene, {5, 5}, 2));
}

TEST(Goal, NanIsInNoGoal) {
  Room room;
  room.goals = {{1, 1, 2, 2}};
  const OpenScene open(room);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(Goal::named(0).contains(open.scene, {nan, 1.5F}, 0));
  EXPECT_FALSE(Goal::named(0).contains(open.scene, {1.5F, nan}, 0));
  EXPECT_FALSE(Goal::disc({5, 5}, 2).contains(open.scene, {nan, nan}, 0));
}

TEST(Goal, ValidWhereItExistsInTheScene) {
  Room room;
  room.goals = {{1, 1, 2, 2}};
  const OpenScene open(room);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(Goal::named(0).valid(open.scene));
  EXPECT_FALSE(Goal::named(1).valid(open.scene));
  EXPECT_FALSE(Goal::named(kNone).valid(open.scene));
  EXPECT_TRUE(Goal::disc({0, 10}, 0.1F).valid(open.scene));
  for (const Goal& bad : {Goal::disc({-0.1F, 5}, 1), Goal::disc({5, 10.1F}, 1), Goal::disc({5, 5}, 0),
                          Goal::disc({5, 5}, -1), Goal::disc({5, 5}, nan), Goal::disc({5, 5}, kInfinity),
                          Goal::disc({nan, 5}, 1), Goal::disc({5, kInfinity}, 1)}) {
    EXPECT_FALSE(bad.valid(open.scene));
  }
}

TEST(Goal, SizeIsTheSideOfASquareOfItsArea) {
  const Opened opened(with_polygon({{1, 1}, {9, 1}, {9, 9}, {7, 9}, {7, 3}, {3, 3}, {3, 9}, {1, 9}}));
  EXPECT_NEAR(static_cast<double>(Goal::named(0).size(opened.scene)), std::sqrt(40.0), 1e-5);
  EXPECT_NEAR(static_cast<double>(Goal::disc({5, 5}, 2).size(opened.scene)), std::sqrt(4 * 3.14159265358979), 1e-5);
}

// How deep the deepest of a grid of points lies.
float depth_of_grid(const Scene& scene, float step) {
  const Box box = Goal::named(0).box(scene);
  float depth = 0.0F;
  for (Vec2 p = box.min; p.x <= box.max.x; p.x += step) {
    for (p.y = box.min.y; p.y <= box.max.y; p.y += step) {
      while (Goal::named(0).contains(scene, p, depth + 0.25F * step)) depth += 0.25F * step;
    }
  }
  return depth;
}

TEST(Goal, HasRoomTwiceAsDeepAsAPlanIsMadeToEnd) {
  const std::vector<std::vector<Vec2>> goals = {
      {{1, 1}, {3, 1}, {3, 3}, {1, 3}},                                      // a square
      {{1, 1}, {9, 1}, {9, 1.0625F}, {1, 1.0625F}},                          // a line
      {{1, 1}, {9, 9}, {8.9375F, 9.0625F}, {0.9375F, 1.0625F}},              // a slanting one
      {{1, 1}, {9, 1}, {9, 9}, {8.875F, 9}, {8.875F, 1.125F}, {1, 1.125F}},  // two lines that meet
      {{1, 1}, {9, 1}, {5, 1.5F}}};                                          // a flat triangle
  for (const std::vector<Vec2>& goal : goals) {
    const Opened opened(with_polygon(goal));
    const float deepest = Goal::named(0).deepest(opened.scene);
    EXPECT_GT(deepest, 0.0F);
    EXPECT_GE(depth_of_grid(opened.scene, 0.0078125F), 1.9F * deepest);
  }
  const Opened square(with_polygon(goals[0]));
  EXPECT_FLOAT_EQ(Goal::named(0).deepest(square.scene), 0.2F);
  EXPECT_FLOAT_EQ(Goal::disc({5, 5}, 2).deepest(square.scene), 0.1F * Goal::disc({5, 5}, 2).size(square.scene));
  const Opened line(with_polygon(goals[1]));
  EXPECT_NEAR(static_cast<double>(Goal::named(0).deepest(line.scene)), 0.0155, 1e-4);
}

// Slivers that floats say have no area, or a negative one: a long side, and a corner a grid step or two off it.
TEST(Goal, SizeOfASliverIsThatOfItsArea) {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    const auto at = [&] { return snap(uniform(random, 0, 10)); };
    const Vec2 a{at(), at()}, b{at(), at()};
    const float part = uniform_float(random, 0, 1);
    const Vec2 c{snap(static_cast<double>(a.x + part * (b.x - a.x))),
                 snap(static_cast<double>(a.y + part * (b.y - a.y)))};
    const std::int64_t twice_area = detail::orientation(detail::to_grid(a), detail::to_grid(b), detail::to_grid(c));
    if (twice_area <= 0) continue;
    const Opened opened(with_polygon({a, b, c}));
    const double area = 0.5 * static_cast<double>(twice_area) / (4096.0 * 4096.0);
    ASSERT_NEAR(static_cast<double>(Goal::named(0).size(opened.scene)), std::sqrt(area), 1e-6 * std::sqrt(area));
  }
}

TEST(Goal, SizeOfTheThinnestSliverInTheLargestWorkspaceIsNoNan) {
  Room room;
  room.bounds = {-2000, -2000, 2000, 2000};
  room.spacing = 500;
  room.bucket_size = 500;
  room.clearance_cell = 32;
  room.goals = {{-2000, -2000, -1500, -1500}};
  SceneData data = data_of(room);
  constexpr double kStep = 1.0 / 4096;
  const double low = -2000, high = 2000;
  data.goals[0] = {{snap(low), snap(low)}, {snap(high), snap(high - kStep)}, {snap(high), snap(high)}};
  const Opened opened(data);
  EXPECT_NEAR(static_cast<double>(Goal::named(0).size(opened.scene)), std::sqrt(0.5 * 4000 * kStep), 1e-6);
  data.goals[0] = {
      {snap(low), snap(low)}, {snap(high), snap(high - kStep)}, {snap(high - kStep), snap(high - 2 * kStep)}};
  std::swap(data.goals[0][1], data.goals[0][2]);
  const Opened thinnest(data);
  EXPECT_NEAR(static_cast<double>(Goal::named(0).size(thinnest.scene)), std::sqrt(0.5) * kStep, 1e-9);
}

}  // namespace
}  // namespace krait::test::goal_test
