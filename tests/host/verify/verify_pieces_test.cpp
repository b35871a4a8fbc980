// SPDX-License-Identifier: Apache-2.0
// The convex pieces cover exactly what the rings fill, whatever their shape.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host/verify/pieces.hpp"
#include "plans.hpp"

namespace krait::host::testing {
namespace {

double area(const std::vector<Ring>& pieces) {
  double twice = 0;
  for (const Ring& ring : pieces) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& a = ring[i];
      const Point& b = ring[(i + 1) % ring.size()];
      twice += a.x * b.y - a.y * b.x;
    }
  }
  return twice / 2;
}

std::size_t count_inside(const std::vector<Ring>& pieces, const Point& point) {
  std::size_t count = 0;
  for (const Ring& piece : pieces) count += inside(piece, point) ? 1 : 0;
  return count;
}

TEST(Pieces, OfARectangleAreItself) {
  const auto pieces = convex_pieces({"o", rectangle(1, 2, 4, 7), {}});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_DOUBLE_EQ(area(pieces), 15);
}

TEST(Pieces, OfABowTieAreItsTwoTriangles) {
  EXPECT_NEAR(area(convex_pieces({"o", {{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}})), 2, 1e-12);
}

TEST(Pieces, LeaveHolesOut) {
  const auto pieces = convex_pieces({"o", rectangle(0, 0, 4, 4), {rectangle(1, 1, 2, 2), rectangle(1.5, 1.5, 3, 3)}});
  EXPECT_NEAR(area(pieces), 16 - (1 + 2.25 - 0.25), 1e-12);
}

TEST(Pieces, AHoleBesideTheOutlineFillsNothing) {
  EXPECT_NEAR(area(convex_pieces({"o", rectangle(0, 0, 2, 2), {rectangle(1, 1, 5, 5)}})), 3, 1e-12);
}

TEST(Pieces, OfALineAreNone) { EXPECT_TRUE(convex_pieces({"o", {{0, 0}, {3, 1}, {0, 0}}, {}}).empty()); }

TEST(Pieces, OfNothingAreNone) { EXPECT_TRUE(convex_pieces({"o", {}, {}}).empty()); }

TEST(Pieces, OfTangledRingsCoverWhatEvenOddFills) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> place(0, 10);
  const auto random_ring = [&](int corners) {
    Ring ring;
    for (int i = 0; i < corners; ++i) ring.push_back({place(generator), place(generator)});
    return ring;
  };
  for (int round = 0; round < 30; ++round) {
    const Obstacle obstacle{"o", random_ring(11), {random_ring(5), random_ring(4)}};
    const auto pieces = convex_pieces(obstacle);
    for (int i = 0; i < 300; ++i) {
      const Point p{place(generator), place(generator)};
      const bool filled = inside(obstacle.outer, p) && !inside(obstacle.holes[0], p) && !inside(obstacle.holes[1], p);
      EXPECT_EQ(count_inside(pieces, p), filled ? 1U : 0U) << round << ": " << p.x << ", " << p.y;
    }
  }
}

TEST(Pieces, OfCornersOnAGridCoverWhatEvenOddFills) {
  std::mt19937 generator(8);
  std::uniform_int_distribution<int> place(0, 4);
  std::uniform_real_distribution<double> anywhere(0, 4);
  for (int round = 0; round < 200; ++round) {
    Ring ring;
    for (int i = 0; i < 9; ++i) ring.push_back({1.0 * place(generator), 1.0 * place(generator)});
    const auto pieces = convex_pieces({"o", ring, {}});
    for (int i = 0; i < 50; ++i) {
      const Point p{anywhere(generator), anywhere(generator)};
      EXPECT_EQ(count_inside(pieces, p), inside(ring, p) ? 1U : 0U) << round << ": " << p.x << ", " << p.y;
    }
  }
}

TEST(Pieces, OfAHopelessTangleAreAnInputErrorInTime) {
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> place(0, 10);
  Ring ring;
  for (int i = 0; i < 5000; ++i) ring.push_back({place(generator), place(generator)});
  EXPECT_THROW(convex_pieces({"obstacles[4]", ring, {}}), InputError);
}

}  // namespace
}  // namespace krait::host::testing
