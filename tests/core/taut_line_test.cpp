// SPDX-License-Identifier: Apache-2.0
// Lines pulled taut: short, free for the disc, between the same ends.
#include "improve/taut_line.hpp"

#include <gtest/gtest.h>

#include "scene_builder.hpp"

namespace krait::test::taut_line_test {
namespace {

constexpr float kRadius = 0.3F;

// A wall from below with a way around its end.
Room wall() {
  Room room;
  room.bounds = {0, 0, 12, 8};
  room.boxes = {{6, 0, 6.25, 5}};
  return room;
}

struct Given {
  OpenScene open;
  std::vector<std::uint64_t> block = std::vector<std::uint64_t>(2000);
  detail::TautLine line;

  explicit Given(std::uint32_t points, const Room& room = wall()) : open(room) {
    detail::Arena arena(block.data(), block.size() * 8);
    line.allocate(arena, points);
  }
  void pull(float widest = kRadius) {
    line.pull(detail::Sight::in(open.scene, widest, 0.1F), kRadius);
    while (line.step()) {
    }
  }
  float length_of() const {
    float whole = 0;
    for (std::uint32_t i = 1; i < line.count(); ++i) whole += length(line[i] - line[i - 1]);
    return whole;
  }
};

// Far around the wall's end, by a staircase.
void wind(detail::TautLine& line) {
  line.clear(0.25F);
  line.add({2, 1});
  for (int i = 0; i < 20; ++i) {
    line.add({2.0F + 0.1F * static_cast<float>(i), 1.0F + 0.3F * static_cast<float>(i)});
    line.add({2.2F + 0.1F * static_cast<float>(i), 1.0F + 0.3F * static_cast<float>(i)});
  }
  for (int i = 0; i < 20; ++i) line.add({4.0F + 0.3F * static_cast<float>(i), 7.0F});
  for (int i = 0; i < 20; ++i) line.add({10.0F, 7.0F - 0.3F * static_cast<float>(i)});
  line.end({10, 1});
}

TEST(TautLine, GoesStraightAroundTheWall) {
  Given given(256);
  wind(given.line);
  const float before = given.length_of();
  given.pull();
  const detail::TautLine& line = given.line;
  EXPECT_EQ(length(line[0] - Vec2{2, 1}), 0.0F);
  EXPECT_EQ(length(line[line.count() - 1] - Vec2{10, 1}), 0.0F);
  EXPECT_LE(line.count(), 6U);
  // A disc's shortest way touches the wall's end with its rim.
  const float shortest = 2 * std::hypot(4.0F, 4.0F + kRadius) + 0.25F;
  EXPECT_LT(given.length_of(), 1.05F * shortest);
  EXPECT_GT(given.length_of(), 0.95F * shortest);
  EXPECT_LT(given.length_of(), 0.8F * before);
  const auto sight = detail::Sight::in(given.open.scene, 0.9F * kRadius, 0.05F);
  for (std::uint32_t i = 1; i < line.count(); ++i) EXPECT_TRUE(sight.line_free(line[i - 1], line[i])) << i;
}

TEST(TautLine, ALineInTheOpenIsStraight) {
  Given given(64);
  given.line.clear(0.1F);
  for (int i = 0; i < 40; ++i) given.line.add({1.0F + 0.1F * static_cast<float>(i), i % 2 == 0 ? 6.0F : 6.5F});
  given.line.end({5, 7});
  given.pull();
  ASSERT_EQ(given.line.count(), 2U);
  EXPECT_EQ(given.line[0].x, 1.0F);
  EXPECT_EQ(given.line[1].x, 5.0F);
}

// A staircase through a corridor of 0.8 m, and in the open behind it.
TEST(TautLine, IsPulledForANarrowerDiscOnlyWhereAWideOneDoesNotFit) {
  Room room;
  room.bounds = {0, 0, 12, 8};
  room.boxes = {{2, 0, 6, 3.6}, {2, 4.4, 6, 8}, {8, 0, 9, 5}};
  Given given(256, room);
  given.line.clear(0.1F);
  for (int i = 0; i < 60; ++i) given.line.add({1.0F + 0.1F * static_cast<float>(i), i % 2 == 0 ? 4.02F : 3.98F});
  for (int i = 0; i < 40; ++i) given.line.add({7.0F + 0.1F * static_cast<float>(i), 6.5F});
  given.line.end({11, 4});
  constexpr float kWidest = 0.9F;
  given.pull(kWidest);
  const detail::TautLine& line = given.line;
  EXPECT_LE(line.count(), 8U);
  for (std::uint32_t i = 1; i < line.count(); ++i) {
    const bool behind = line[i - 1].x > 6.5F;
    const auto sight = detail::Sight::in(given.open.scene, 0.9F * (behind ? kWidest : kRadius), 0.05F);
    EXPECT_TRUE(sight.line_free(line[i - 1], line[i])) << i;
  }
}

TEST(TautLine, ThinsOutWhereItIsFull) {
  for (const std::uint32_t points : {2U, 3U, 16U, 17U}) {
    Given given(points);
    given.line.clear(0.01F);
    for (int i = 0; i < 1000; ++i) given.line.add({1.0F + 0.004F * static_cast<float>(i), 6});
    given.line.end({5.5F, 6});
    EXPECT_LE(given.line.count(), points);
    EXPECT_GE(given.line.count(), 2U);
    EXPECT_EQ(given.line[0].x, 1.0F);
    EXPECT_EQ(given.line[given.line.count() - 1].x, 5.5F);
    given.pull();
    EXPECT_EQ(given.line.count(), 2U) << points;
  }
}

TEST(TautLine, ALineThatNothingFreesStaysWhereItIs) {
  Given given(64);
  given.line.clear(0.1F);
  given.line.add({5, 1});
  given.line.end({7, 1});  // straight through the wall
  given.pull();
  EXPECT_EQ(given.line[0].x, 5.0F);
  EXPECT_EQ(given.line[given.line.count() - 1].x, 7.0F);
  for (std::uint32_t i = 1; i < given.line.count(); ++i) {
    EXPECT_GT(given.line[i].x, given.line[i - 1].x);
    EXPECT_EQ(given.line[i].y, 1.0F);
  }
}

}  // namespace
}  // namespace krait::test::taut_line_test
