// SPDX-License-Identifier: Apache-2.0
// Dubins' words against the formulas of Shkel and Lumelsky (Classification of the Dubins set, 2001) in double.
#include "last_metres/dubins.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "draws.hpp"

namespace krait::test::dubins_test {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

struct Place {
  double x, y, heading;
};

double positive(double angle) {
  const double rest = std::fmod(angle, kTurn);
  return rest < 0 ? rest + kTurn : rest;
}

// Lengths of the three parts in radii, for poses that are `d` radii apart, headings seen from the line between them.
std::optional<std::array<double, 3>> parts(int word, double d, double a, double b) {
  const double sa = std::sin(a), sb = std::sin(b), ca = std::cos(a), cb = std::cos(b), cab = std::cos(a - b);
  const bool left = word % 2 == 0;
  if (word < 2) {
    const double sines = left ? sa - sb : sb - sa;
    const double squared = 2 + d * d - 2 * cab + 2 * d * sines;
    if (squared < 0) return {};
    const double to = std::atan2(left ? cb - ca : ca - cb, d + sines);
    if (left) return {{positive(to - a), std::sqrt(squared), positive(b - to)}};
    return {{positive(a - to), std::sqrt(squared), positive(to - b)}};
  }
  if (word < 4) {
    const double sines = left ? sa + sb : -(sa + sb);
    const double squared = -2 + d * d + 2 * cab + 2 * d * sines;
    if (squared < 0) return {};
    const double p = std::sqrt(squared);
    if (left) {
      const double to = std::atan2(-ca - cb, d + sa + sb) - std::atan2(-2.0, p);
      return {{positive(to - a), p, positive(to - b)}};
    }
    const double to = std::atan2(ca + cb, d - sa - sb) - std::atan2(2.0, p);
    return {{positive(a - to), p, positive(b - to)}};
  }
  const double cosine = (6 - d * d + 2 * cab + 2 * d * (left ? sb - sa : sa - sb)) / 8;
  if (std::abs(cosine) > 1) return {};
  const double p = kTurn - std::acos(cosine);
  if (left) {
    const double t = positive(-a - std::atan2(ca - cb, d + sa - sb) + p / 2);
    return {{t, p, positive(b - a - t + p)}};
  }
  const double t = positive(a - std::atan2(ca - cb, d - sa + sb) + p / 2);
  return {{t, p, positive(a - b - t + p)}};
}

std::optional<double> reference_length(int word, const Place& from, const Place& to, double radius) {
  const double direction = std::atan2(to.y - from.y, to.x - from.x);
  const double d = std::hypot(to.x - from.x, to.y - from.y) / radius;
  const auto found = parts(word, d, from.heading - direction, to.heading - direction);
  if (!found) return {};
  return radius * ((*found)[0] + (*found)[1] + (*found)[2]);
}

Pose pose(const Place& place) {
  return {{static_cast<float>(place.x), static_cast<float>(place.y)}, math::sin_cos(static_cast<float>(place.heading))};
}

double apart(const Pose& a, const Pose& b) { return static_cast<double>(length(a.position - b.position)); }

// Draws the word's line; false where it has none.
bool dubins_line(int word, const Pose& from, const Pose& to, float radius, detail::CurvedLine& line) {
  detail::DubinsPieces pieces;
  if (!detail::dubins(word, from, to, radius, pieces)) return false;
  line = detail::CurvedLine(from, radius);
  line.add(pieces);
  return true;
}

class Dubins : public ::testing::Test {
 protected:
  Place place() {
    const auto draw = [this](float most) { return static_cast<double>(uniform_float(random_, -most, most)); };
    return {draw(5), draw(5), draw(3)};
  }

  std::mt19937 random_{7};
};

TEST_F(Dubins, LengthsAreThoseOfTheFormulas) {
  int compared[detail::kDubinsWords] = {};
  for (int i = 0; i < 20'000; ++i) {
    const Place from = place(), to = place();
    const float radius = uniform_float(random_, 0.3F, 3);
    for (int word = 0; word < detail::kDubinsWords; ++word) {
      detail::CurvedLine line;
      const bool found = dubins_line(word, pose(from), pose(to), radius, line);
      const auto expected = reference_length(word, from, to, static_cast<double>(radius));
      if (!expected || !found) continue;
      // Where a turn is none but for rounding, one of them may make a whole circle of it.
      const double circle = kTurn * static_cast<double>(radius);
      const double off = std::remainder(static_cast<double>(line.length()) - *expected, circle);
      ASSERT_NEAR(off, 0, 5e-3 * static_cast<double>(radius)) << "word " << word;
      if (std::abs(static_cast<double>(line.length()) - *expected) < circle / 2) ++compared[word];
    }
  }
  for (const int count : compared) EXPECT_GT(count, 1000);
}

TEST_F(Dubins, WhatALineCurvesFromAPlaceOnIsThatOfItsTurns) {
  for (int i = 0; i < 300; ++i) {
    const Place from = place(), to = place();
    const float radius = uniform_float(random_, 0.3F, 3);
    for (int word = 0; word < detail::kDubinsWords; ++word) {
      detail::CurvedLine line;
      if (!dubins_line(word, pose(from), pose(to), radius, line)) continue;
      constexpr int kParts = 1000;
      const float step = line.length() / kParts;
      double curve = 0;
      for (int k = kParts; k >= 0; --k) {
        const Pose here = line.at(step * static_cast<float>(k));
        ASSERT_NEAR(static_cast<double>(line.curve_from(step * static_cast<float>(k))), curve, 5e-2) << "word " << word;
        curve += static_cast<double>(angle_between(line.at(step * static_cast<float>(k - 1)).heading, here.heading));
      }
    }
  }
}

TEST_F(Dubins, OneFindsAWordWhereTheOtherDoes) {
  int differ = 0;
  int found_some = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Place from = place(), to = place();
    for (int word = 0; word < detail::kDubinsWords; ++word) {
      detail::CurvedLine line;
      const bool found = dubins_line(word, pose(from), pose(to), 1, line);
      found_some += found ? 1 : 0;
      differ += found != reference_length(word, from, to, 1).has_value() ? 1 : 0;
    }
  }
  EXPECT_GT(found_some, 40'000);
  EXPECT_LT(differ, 10) << "but for rounding";
}

TEST_F(Dubins, LinesEndAtThePoseAndBendAsMuchAsTheRadiusAllows) {
  for (int i = 0; i < 2'000; ++i) {
    const Pose from = pose(place()), to = pose(place());
    const float radius = uniform_float(random_, 0.3F, 3);
    for (int word = 0; word < detail::kDubinsWords; ++word) {
      detail::CurvedLine line;
      if (!dubins_line(word, from, to, radius, line)) continue;
      ASSERT_LT(apart(line.at(0), from), 1e-4);
      ASSERT_LT(apart(line.at(line.length()), to), 5e-3) << "word " << word;
      ASSERT_LT(angle_between(line.at(line.length()).heading, to.heading), 5e-3F) << "word " << word;
      constexpr int kParts = 50;
      const float step = line.length() / kParts;
      for (int k = 0; k < kParts; ++k) {
        const Pose a = line.at(step * static_cast<float>(k)), b = line.at(step * static_cast<float>(k + 1));
        ASSERT_LE(apart(a, b), static_cast<double>(step) + 1e-4);
        if (step > radius) continue;
        ASSERT_LE(angle_between(a.heading, b.heading), step / radius + 1e-3F);
      }
    }
  }
}

TEST_F(Dubins, TheShortestWordIsNoShorterThanTheLineBetweenThePoses) {
  for (int i = 0; i < 2'000; ++i) {
    const Pose from = pose(place()), to = pose(place());
    float least = kInfinity;
    for (int word = 0; word < detail::kDubinsWords; ++word) {
      detail::CurvedLine line;
      if (dubins_line(word, from, to, 1, line) && line.length() < least) least = line.length();
    }
    ASSERT_LT(least, kInfinity) << "two poses are always joined";
    ASSERT_GE(static_cast<double>(least), apart(from, to) - 1e-4);
  }
}

TEST(CurvedLine, TurnsOnTheSpotTheShorterWayBetweenPieces) {
  detail::CurvedLine line({{1, 2}, math::sin_cos(0)}, 1);
  line.face(math::sin_cos(1.5F * kPi));
  line.add(0, 2);
  line.face(math::sin_cos(kPi));
  line.add(0, 1);
  EXPECT_NEAR(line.turned(), kPi, 1e-6);
  EXPECT_EQ(line.length(), 3);
  EXPECT_NEAR(line.at(1.5F).position.y, 0.5, 1e-6);
  EXPECT_NEAR(angle_between(line.at(1.5F).heading, math::sin_cos(-0.5F * kPi)), 0, 1e-6);
  EXPECT_NEAR(line.end().position.x, 0, 1e-6);
  EXPECT_NEAR(line.end().position.y, 0, 1e-6);
}

TEST(CurvedLine, GoesOnStraightBeyondItsEnds) {
  detail::CurvedLine line({{1, 2}, math::sin_cos(0)}, 1);
  line.add(1, 0.5F * kPi);
  EXPECT_NEAR(line.at(-1).position.x, 0, 1e-6);
  EXPECT_NEAR(line.end().position.x, 2, 1e-6);
  EXPECT_NEAR(line.end().position.y, 3, 1e-6);
  EXPECT_NEAR(line.at(line.length() + 2).position.y, 5, 1e-5);
}

}  // namespace
}  // namespace krait::test::dubins_test
