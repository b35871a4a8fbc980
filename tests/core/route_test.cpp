// SPDX-License-Identifier: Apache-2.0
// Places along a line of vias: points, projections, changes.
#include "improve/route.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "draws.hpp"

namespace krait::test::route_test {
namespace {

struct Given {
  std::vector<std::uint64_t> block = std::vector<std::uint64_t>(1000);
  detail::Arena arena{block.data(), block.size() * 8};
  detail::Route route;

  explicit Given(const std::vector<Vec2>& points, std::uint32_t capacity = 64) {
    route.allocate(arena, capacity);
    for (std::size_t i = 0; i < points.size(); ++i) route.add({points[i], static_cast<float>(i), 1.0F, 0.0F});
    route.measure();
  }
};

const std::vector<Vec2> kHook = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};

TEST(Route, TellsPlacesByTheirArc) {
  const Given given(kHook);
  EXPECT_EQ(given.route.length(), 11.0F);
  const auto expect = [&](float arc, Vec2 at, std::uint32_t stretch) {
    EXPECT_FLOAT_EQ(given.route.point(arc).x, at.x) << arc;
    EXPECT_FLOAT_EQ(given.route.point(arc).y, at.y) << arc;
    EXPECT_EQ(given.route.stretch(arc), stretch) << arc;
  };
  expect(0, {0, 0}, 1);
  expect(1, {1, 0}, 1);
  expect(4, {4, 0}, 2);
  expect(6, {4, 2}, 2);
  expect(8, {3, 3}, 3);
  expect(11, {0, 3}, 3);
  expect(100, {0, 3}, 3);
}

TEST(Route, ProjectsOntoTheNearestPlaceWithinReach) {
  const Given given(kHook);
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p{uniform_float(random, -1, 5), uniform_float(random, -1, 4)};
    const float from = uniform_float(random, 0, 11);
    const float reach = uniform_float(random, 0, 6);
    const float found = given.route.project(p, from, reach);
    const float end = std::min(from + reach, 11.0F);
    ASSERT_GE(found, from);
    ASSERT_LE(found, end);
    float least = kInfinity;
    for (float arc = from; arc <= end; arc += 0.01F) least = std::min(least, length(given.route.point(arc) - p));
    ASSERT_LE(length(given.route.point(found) - p), least + 1e-4F);
  }
}

TEST(Route, DividesAStretchWhereTheLineStays) {
  Given given(kHook);
  EXPECT_EQ(given.route.divide(5.5F), 2U);
  EXPECT_EQ(given.route.count(), 5U);
  EXPECT_EQ(given.route[2].at.y, 1.5F);
  EXPECT_EQ(given.route[2].look, 2.0F);  // as the stretch that was
  for (float arc = 0; arc < 11; arc += 0.5F) {
    EXPECT_EQ(length(given.route.point(arc) - Given(kHook).route.point(arc)), 0.0F) << arc;
  }
  given.route.measure();
  EXPECT_EQ(given.route.length(), 11.0F);
}

TEST(Route, RemovesAndCopiesVias) {
  Given given(kHook, 5);
  Given other({{9, 9}}, 5);
  given.route.remove(1);
  other.route.copy(given.route);
  other.route.measure();
  EXPECT_EQ(other.route.count(), 3U);
  EXPECT_EQ(other.route.length(), 5.0F + 4.0F);
  EXPECT_FALSE(other.route.full());
  other.route.add({{0, 4}, 1, 1, 0});
  other.route.add({{0, 5}, 1, 1, 0});
  EXPECT_TRUE(other.route.full());
}

TEST(Route, ViasAtOnePlaceAreNoTrouble) {
  const Given given({{1, 1}, {1, 1}, {3, 1}, {3, 1}});
  EXPECT_EQ(given.route.length(), 2.0F);
  EXPECT_EQ(given.route.point(1.0F).x, 2.0F);
  EXPECT_EQ(given.route.project({2.5F, 4}, 0, 10), 1.5F);
  EXPECT_EQ(given.route.point(2.0F).x, 3.0F);
}

}  // namespace
}  // namespace krait::test::route_test
