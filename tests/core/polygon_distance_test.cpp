// SPDX-License-Identifier: Apache-2.0
// Box2D's distance in float against Boost.Geometry in double.
#include <gtest/gtest.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "collision/distance.hpp"
#include "convex.hpp"

namespace krait::test::polygon_distance_test {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false>;

BoostPolygon boost_polygon(const std::vector<Vec2>& vertices, Point shift = {0, 0}) {
  BoostPolygon result;
  for (const Vec2 v : vertices) bg::append(result, BoostPoint(point(v).x + shift.x, point(v).y + shift.y));
  bg::correct(result);
  return result;
}

Polygon view(const std::vector<Vec2>& vertices) { return {vertices.data(), static_cast<int>(vertices.size())}; }

double got(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return static_cast<double>(detail::polygon_distance(view(a), view(b)));
}

TEST(PolygonDistance, OfRandomConvexPolygonsNearby) {
  std::mt19937 random(1);
  int apart = 0, overlapping = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto a = random_convex(random, {0, 0}, 1.5);
    const auto b = random_convex(random, {uniform(random, -3, 3), uniform(random, -3, 3)}, 1.5);
    const double expected = bg::distance(boost_polygon(a), boost_polygon(b));
    ASSERT_NEAR(got(a, b), expected, 3e-6);
    ASSERT_NEAR(distance(ring(view(a)), ring(view(b))), expected, 1e-9);  // the other tests' own oracle
    (expected > 0 ? apart : overlapping) += 1;
  }
  EXPECT_GT(apart, 5000);
  EXPECT_GT(overlapping, 3000);
}

TEST(PolygonDistance, FarApart) {
  std::mt19937 random(2);
  for (int i = 0; i < 3000; ++i) {
    const auto a = random_convex(random, {0, 0}, 1);
    const auto b = random_convex(random, {uniform(random, -500, 500), uniform(random, -500, 500)}, 20);
    const double expected = bg::distance(boost_polygon(a), boost_polygon(b));
    ASSERT_NEAR(got(a, b), expected, 1e-6 * (1 + 520));
  }
}

// Seen from one of the two, as the core does, the distance is as good at 1,000 m as at the origin.
TEST(PolygonDistance, AtAThousandMetresThroughRelativeCoordinates) {
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    const Point far{uniform(random, -1999, 1999), uniform(random, -1999, 1999)};
    const auto a = random_convex(random, far, 1);
    const auto b = random_convex(random, {far.x + uniform(random, -2, 2), far.y + uniform(random, -2, 2)}, 1);
    auto near_a = a, near_b = b;
    for (Vec2& v : near_a) v = v - a[0];
    for (Vec2& v : near_b) v = v - a[0];
    ASSERT_NEAR(got(near_a, near_b), bg::distance(boost_polygon(a), boost_polygon(b)), 5e-6);
  }
}

TEST(PolygonDistance, NestedIsZero) {
  std::mt19937 random(4);
  for (int i = 0; i < 2000; ++i) {
    const auto outer = corners({-3, -3, 3, 3});
    const auto inner = random_convex(random, {uniform(random, -1, 1), uniform(random, -1, 1)}, 1);
    ASSERT_NEAR(got(outer, inner), 0, 1e-6);
    ASSERT_NEAR(got(inner, outer), 0, 1e-6);
    ASSERT_NEAR(got(inner, inner), 0, 1e-6);
  }
}

TEST(PolygonDistance, TouchingIsZero) {
  const auto a = corners({0, 0, 1, 1});
  EXPECT_NEAR(got(a, corners({1, 0, 2, 1})), 0, 1e-6);       // a side
  EXPECT_NEAR(got(a, corners({1, 0.5, 2, 0.75})), 0, 1e-6);  // part of one
  EXPECT_NEAR(got(a, corners({1, 1, 2, 2})), 0, 1e-6);       // a corner
  EXPECT_NEAR(got(a, {{1, 0.5F}, {2, 0}, {2, 1}}), 0, 1e-6);
}

TEST(PolygonDistance, OfAGridStepIsSeen) {
  const auto a = corners({0, 0, 1, 1});
  EXPECT_NEAR(got(a, corners({1 + 1.0 / 4096, 0, 2, 1})), 1.0 / 4096, 1e-6);
  EXPECT_NEAR(got(a, corners({1 + 1.0 / 4096, 1 + 1.0 / 4096, 2, 2})), std::sqrt(2.0) / 4096, 1e-6);
}

TEST(PolygonDistance, IsTheSameFromBothSides) {
  std::mt19937 random(5);
  for (int i = 0; i < 5000; ++i) {
    const auto a = random_convex(random, {0, 0}, 1.5);
    const auto b = random_convex(random, {uniform(random, -3, 3), uniform(random, -3, 3)}, 1.5);
    ASSERT_NEAR(got(a, b), got(b, a), 3e-6);
  }
}

// Slivers: a wall of a centimetre and a hundred metres.
TEST(PolygonDistance, ToALongThinWall) {
  std::mt19937 random(6);
  for (int i = 0; i < 3000; ++i) {
    const double x = uniform(random, -1, 1);
    const auto wall = corners({x, -50, x + 0.01, 50});
    const auto body = random_convex(random, {0, uniform(random, -52, 52)}, 0.5);
    auto near_wall = wall, near_body = body;
    for (Vec2& v : near_wall) v = v - body[0];
    for (Vec2& v : near_body) v = v - body[0];
    ASSERT_NEAR(got(near_wall, near_body), bg::distance(boost_polygon(wall), boost_polygon(body)), 1e-6 * 100);
  }
}

}  // namespace
}  // namespace krait::test::polygon_distance_test
