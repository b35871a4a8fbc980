// SPDX-License-Identifier: Apache-2.0
// The nearest point against brute force.
#include "host/rivals/nearest.hpp"

#include <gtest/gtest.h>

#include "scene_builder.hpp"

namespace krait::test::nearest_test {
namespace {

using rivals::NearestPoints;

// Memory that ends where the points' does.
struct Points {
  Points(Rect bounds, std::uint32_t capacity) : open(room(bounds)) {
    detail::Arena counting;
    nearest.allocate(counting, open.scene, capacity);
    bytes = counting.needed();
    block.resize(bytes / 8);
    detail::Arena arena(block.data(), bytes);
    nearest.allocate(arena, open.scene, capacity);
    nearest.clear();
  }
  static Room room(Rect bounds) {
    Room result;
    result.bounds = bounds;
    result.spacing = result.bucket_size = result.clearance_cell =
        0.1 * std::max(bounds.x1 - bounds.x0, bounds.y1 - bounds.y0);
    return result;
  }

  void insert(Vec2 p) {
    nearest.insert(p);
    all.push_back(p);
  }
  Index by_brute_force(Vec2 p) const {
    Index best = kNone;
    float least = kInfinity;
    for (Index i = 0; i < all.size(); ++i) {
      const float squared = dot(p - all[i], p - all[i]);
      if (squared < least) {
        least = squared;
        best = i;
      }
    }
    return best;
  }
  Vec2 anywhere(std::mt19937& random) const {
    const Box b = open.scene.bounds();
    return {uniform_float(random, static_cast<double>(b.min.x), static_cast<double>(b.max.x)),
            uniform_float(random, static_cast<double>(b.min.y), static_cast<double>(b.max.y))};
  }

  OpenScene open;
  std::uint64_t bytes;
  std::vector<std::uint64_t> block;
  NearestPoints nearest;
  std::vector<Vec2> all;
};

TEST(NearestPoints, WithoutPointsThereIsNone) {
  const Points points({0, 0, 10, 10}, 100);
  EXPECT_EQ(points.nearest.nearest({5, 5}), kNone);
}

TEST(NearestPoints, AgreesWithBruteForceWhileItFills) {
  for (const std::uint32_t capacity : {1U, 2U, 7U, 8U, 100U, 3000U}) {
    Points points({-3, 2, 17, 14}, capacity);
    std::mt19937 random(capacity);
    for (std::uint32_t i = 0; i < capacity; ++i) {
      points.insert(points.anywhere(random));
      const Vec2 p = points.anywhere(random);
      ASSERT_EQ(points.nearest.nearest(p), points.by_brute_force(p)) << i;
    }
  }
}

TEST(NearestPoints, AgreesWithBruteForceInLongThinAndHugeWorkspaces) {
  for (const Rect& bounds : {Rect{0, 0, 100, 0.5}, Rect{5, -50, 5.25, 50}, Rect{-2000, -2000, 2000, 2000}}) {
    Points points(bounds, 2000);
    std::mt19937 random(1);
    for (int i = 0; i < 2000; ++i) points.insert(points.anywhere(random));
    for (int i = 0; i < 2000; ++i) {
      const Vec2 p = points.anywhere(random);
      ASSERT_EQ(points.nearest.nearest(p), points.by_brute_force(p));
    }
  }
}

TEST(NearestPoints, AmongEqualsTheFirstIsTaken) {
  Points points({0, 0, 16, 16}, 2000);
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    points.insert({static_cast<float>(random() % 17), static_cast<float>(random() % 17)});
    const Vec2 p{static_cast<float>(random() % 33) / 2, static_cast<float>(random() % 33) / 2};
    ASSERT_EQ(points.nearest.nearest(p), points.by_brute_force(p));
  }
}

TEST(NearestPoints, ManyInOnePlaceAndInClusters) {
  Points points({0, 0, 10, 10}, 5000);
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) points.insert({7, 3});
  for (int i = 0; i < 4000; ++i) {
    const float x = static_cast<float>(random() % 3), y = static_cast<float>(random() % 3);
    points.insert({1 + x + uniform_float(random, 0, 0.01), 1 + y + uniform_float(random, 0, 0.01)});
  }
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p = points.anywhere(random);
    ASSERT_EQ(points.nearest.nearest(p), points.by_brute_force(p));
  }
}

TEST(NearestPoints, OnBoundsAndCellBordersAndOutside) {
  Points points({0, 0, 10, 10}, 4000);
  std::mt19937 random(4);
  const auto on_border = [&] { return static_cast<float>(random() % 65) * 10 / 64; };
  for (int i = 0; i < 4000; ++i) points.insert({on_border(), on_border()});
  for (int i = 0; i < 4000; ++i) {
    const Vec2 p{on_border() + uniform_float(random, -1e-6, 1e-6), on_border()};
    ASSERT_EQ(points.nearest.nearest(p), points.by_brute_force(p));
    const Vec2 far{uniform_float(random, -100, 100), uniform_float(random, -100, 100)};
    ASSERT_EQ(points.nearest.nearest(far), points.by_brute_force(far));
  }
}

TEST(NearestPoints, ClearForgetsAll) {
  Points points({0, 0, 10, 10}, 10);
  for (int i = 0; i < 10; ++i) points.insert({1, 1});
  points.nearest.clear();
  EXPECT_EQ(points.nearest.nearest({1, 1}), kNone);
  points.nearest.insert({9, 9});
  EXPECT_EQ(points.nearest.nearest({1, 1}), 0U);
}

TEST(NearestPoints, NeedsAtMost15BytesAPoint) {
  for (const std::uint32_t capacity : {1000U, 10'000U, 100'000U}) {
    EXPECT_LE(Points({0, 0, 50, 50}, capacity).bytes, 15 * capacity + 40U);
  }
}

}  // namespace
}  // namespace krait::test::nearest_test
