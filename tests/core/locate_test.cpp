// SPDX-License-Identifier: Apache-2.0
// LOCATEREGION against brute force over all triangles in exact arithmetic.
#include "decomposition/locate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scene_builder.hpp"

namespace krait::test::locate_test {
namespace {

// All triangles whose closed area contains the point of the grid that is nearest to p. Doubles are exact here.
std::vector<Index> triangles_at(const Scene& scene, Vec2 p) {
  const auto grid = [](Vec2 v) {
    return Point{std::round(static_cast<double>(v.x) * 4096), std::round(static_cast<double>(v.y) * 4096)};
  };
  std::vector<Index> result;
  for (Index t = 0; t < scene.triangle_count(); ++t) {
    bool inside = true;
    for (int i = 0; i < 3; ++i)
      inside = inside && side(grid(scene.corner(t, i)), grid(scene.corner(t, (i + 1) % 3)), grid(p)) >= 0;
    if (inside) result.push_back(t);
  }
  return result;
}

void expect_located(const Scene& scene, Vec2 p, Index hint) {
  const auto containing = triangles_at(scene, p);
  const Index found = detail::locate(scene, p, hint);
  if (containing.empty()) {
    ASSERT_EQ(found, kNone) << p.x << " " << p.y;
  } else {
    ASSERT_NE(std::find(containing.begin(), containing.end(), found), containing.end())
        << p.x << " " << p.y << " " << found;
  }
}

Index random_hint(const Scene& scene, std::mt19937& random) {
  return random() % 4 == 0 ? kNone : static_cast<Index>(random() % scene.triangle_count());
}

TEST(Locate, RandomPointsAndHints) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const OpenScene open(random_room(seed));
    std::mt19937 random(seed);
    for (int i = 0; i < 3000; ++i) {
      const Vec2 p{uniform_float(random, 0, 12), uniform_float(random, 0, 12)};
      expect_located(open.scene, p, random_hint(open.scene, random));
    }
  }
}

TEST(Locate, PointsOnVerticesAndEdges) {
  const OpenScene open(random_room(20));
  std::mt19937 random(20);
  for (Index t = 0; t < open.scene.triangle_count(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Vec2 a = open.scene.corner(t, i), b = open.scene.corner(t, (i + 1) % 3);
      expect_located(open.scene, a, random_hint(open.scene, random));
      expect_located(open.scene, 0.5F * (a + b), random_hint(open.scene, random));
      expect_located(open.scene, a, kNone);
    }
  }
}

TEST(Locate, FarFromTheOriginAndWithNegativeCoordinates) {
  for (const double shift : {-1990.0, -6.0, 1985.0}) {
    Room room;
    room.bounds = {shift, -shift - 12, shift + 12, -shift};
    room.boxes = {{shift + 3, -shift - 9, shift + 5, -shift - 4},
                  {shift + 7.3, -shift - 3.1, shift + 7.31, -shift - 1}};
    const OpenScene open(room);
    std::mt19937 random(5);
    for (int i = 0; i < 3000; ++i) {
      const Vec2 p{uniform_float(random, shift, shift + 12), uniform_float(random, -shift - 12, -shift)};
      expect_located(open.scene, p, random_hint(open.scene, random));
    }
  }
}

TEST(Locate, WideSceneWhereBucketsAreFoundInFloat) {
  Room room;
  room.bounds = {-2000, -2000, 2000, 2000};
  room.spacing = 200;
  room.bucket_size = 63.7;
  room.clearance_cell = 100;
  const OpenScene open(room);
  std::mt19937 random(6);
  const auto size = static_cast<double>(open.scene.header().bucket_size);
  for (int i = 0; i < 2000; ++i) {  // on and beside the buckets' borders
    const double x =
        -2000 + size * static_cast<double>(random() % 62) + static_cast<double>(random() % 5) / 4096 - 2.0 / 4096;
    const Vec2 p{std::max(-2000.0F, snap(x)), uniform_float(random, -2000, 2000)};
    expect_located(open.scene, p, kNone);
  }
}

TEST(Locate, EveryHintWorksForOnePoint) {
  const OpenScene open(random_room(4));
  std::mt19937 random(4);
  for (int i = 0; i < 20; ++i) {
    const Vec2 p{uniform_float(random, 0, 12), uniform_float(random, 0, 12)};
    for (Index hint = 0; hint < open.scene.triangle_count(); ++hint) expect_located(open.scene, p, hint);
  }
}

TEST(Locate, OutsideAndNotFinite) {
  const OpenScene open(random_room(1));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Vec2 p : {Vec2{-0.001F, 5}, Vec2{12.001F, 5}, Vec2{5, -1e30F}, Vec2{5, 1e30F}, Vec2{kInfinity, 5},
                       Vec2{5, -kInfinity}, Vec2{nan, 5}, Vec2{5, nan}}) {
    EXPECT_EQ(detail::locate(open.scene, p), kNone);
    EXPECT_EQ(detail::locate(open.scene, p, 0), kNone);
  }
}

TEST(Locate, InsideAnObstacle) {
  Room room;
  room.boxes = {{4, 4, 6, 6}};
  const OpenScene open(room);
  EXPECT_EQ(detail::locate(open.scene, {5, 5}), kNone);
  EXPECT_EQ(detail::locate(open.scene, {5, 5}, 0), kNone);
  EXPECT_NE(detail::locate(open.scene, {4, 5}), kNone);  // on its border
}

}  // namespace
}  // namespace krait::test::locate_test
