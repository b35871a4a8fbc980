// SPDX-License-Identifier: Apache-2.0
// Scene::open on sound bytes: what the view says is what was written; and nothing that is not sound gets through.
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "scene_builder.hpp"

namespace krait::test::scene_open_test {
namespace {

Room small_room() {
  Room room;
  room.bounds = {0, 0, 4, 3};
  room.boxes = {{1, 1, 2, 2}};
  room.goals = {{3, 2, 4, 3}, {3, 0, 4, 1}};
  room.starts = {{0.5F, 0.5F, 0.25F, 0, 2}, {0.5F, 2.5F, -1.0F, 2, 0}};
  room.start_angles = {0.125F, 0.5F};
  return room;
}

SceneBytes copy(const SceneBytes& bytes, std::size_t size) {
  SceneBytes result(size);
  std::copy_n(bytes.data(), std::min(size, bytes.size()), result.data());
  return result;
}

Failure open(const SceneBytes& bytes) {
  Scene scene;
  return Scene::open(bytes.data(), bytes.size(), scene);
}

TEST(SceneBuilder, ChecksumIsThatOfIeee8023) {
  SceneBytes bytes(25);  // the sum runs from byte 16: the nine digits of its standard check value
  std::memcpy(bytes.data() + 16, "123456789", 9);
  bytes.repair_crc();
  EXPECT_EQ(bytes.get<std::uint32_t>(12), 0xCBF43926U);
}

class SceneOpen : public ::testing::TestWithParam<int> {
 protected:
  Room room() const {
    Room result = small_room();
    result.index_width = static_cast<std::uint8_t>(GetParam());
    return result;
  }
};

TEST_P(SceneOpen, ViewsWhatWasWritten) {
  const SceneData data = data_of(room());
  const OpenScene open(room());
  const Scene& s = open.scene;
  ASSERT_EQ(s.triangle_count(), data.triangles.size());
  ASSERT_EQ(s.portal_count(), data.portal_widths.size());
  for (Index t = 0; t < s.triangle_count(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Vec2 written = data.vertices[data.triangles[t][k]];
      EXPECT_EQ(s.corner(t, i).x, written.x);
      EXPECT_EQ(s.corner(t, i).y, written.y);
      EXPECT_EQ(s.neighbor(t, i), data.neighbors[t][k]);
      EXPECT_EQ(s.portal(t, i), data.portals[t][k]);
    }
    EXPECT_EQ(s.goal_of(t), data.triangle_goals[t] == format::kNone16 ? kNone : data.triangle_goals[t]);
  }
  for (Index p = 0; p < s.portal_count(); ++p) EXPECT_EQ(s.portal_width(p), data.portal_widths[p]);
  ASSERT_EQ(s.piece_count(), 1U);
  EXPECT_EQ(s.piece(0).count, 4);
  EXPECT_EQ(s.piece_box(0).max.x, 2.0F);
  EXPECT_EQ(s.bytes(), open.bytes.size());
}

TEST_P(SceneOpen, FindsNamesGoalsAndStarts) {
  const OpenScene open(room());
  const Scene& s = open.scene;
  EXPECT_STREQ(s.name(), "room");
  EXPECT_EQ(s.find_goal("goal1"), 1U);
  EXPECT_EQ(s.find_goal("goal"), kNone);
  EXPECT_EQ(s.find_goal("start0"), kNone);
  EXPECT_STREQ(s.start_name(1), "start1");
  EXPECT_EQ(s.goal_polygon(1).count, 4);
  EXPECT_EQ(s.goal_polygon(1)[0].y, 0.0F);
  const ScenePose start = s.start(0);
  EXPECT_EQ(start.heading, 0.25F);
  ASSERT_EQ(start.angle_count, 2U);
  EXPECT_EQ(start.angles[1], 0.5F);
  EXPECT_EQ(s.start(1).angle_count, 0U);
}

TEST_P(SceneOpen, ClearanceIsNeverMoreThanTheTrueDistance) {
  const OpenScene open(room());
  const Ring piece = ring(open.scene.piece(0));
  std::mt19937 random(1);
  double largest = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec2 at{uniform_float(random, -1, 5), uniform_float(random, -1, 4)};
    const Point p = point(at);
    double distance = std::min(std::min(p.x, 4 - p.x), std::min(p.y, 3 - p.y));
    distance = std::max(0.0, std::min(distance, distance_to_convex(p, piece)));
    ASSERT_LE(static_cast<double>(open.scene.clearance().at(at)), distance);
    largest = std::max(largest, static_cast<double>(open.scene.clearance().at(at)));
  }
  EXPECT_GT(largest, 0.05);
}

TEST_P(SceneOpen, EveryTruncationIsRejected) {
  const SceneBytes whole = data_of(room()).bytes();
  ASSERT_TRUE(open(whole).ok());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Failure failure = open(copy(whole, size));
    ASSERT_EQ(failure.status, Status::bad_scene) << size;
    ASSERT_EQ(failure.section, Scene::kHeaderSection) << size;
  }
}

TEST_P(SceneOpen, EveryTruncationWithRightLengthAndSumIsRejected) {
  const SceneBytes whole = data_of(room()).bytes();
  for (std::size_t size = sizeof(format::Header); size < whole.size(); ++size) {
    SceneBytes cut = copy(whole, size);
    cut.put(offsetof(format::Header, total_bytes), static_cast<std::uint32_t>(size));
    cut.repair_crc();
    ASSERT_EQ(open(cut).status, Status::bad_scene) << size;
  }
}

TEST_P(SceneOpen, LongerThanItSaysIsRejected) {
  const SceneBytes whole = data_of(room()).bytes();
  EXPECT_EQ(open(copy(whole, whole.size() + 1)).element, offsetof(format::Header, total_bytes));
  SceneBytes longer = copy(whole, whole.size() + 4);
  longer.put(offsetof(format::Header, total_bytes), static_cast<std::uint32_t>(longer.size()));
  longer.repair_crc();
  EXPECT_EQ(open(longer).status, Status::bad_scene);
}

TEST_P(SceneOpen, EveryChangedByteIsRejected) {
  SceneBytes bytes = data_of(room()).bytes();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const unsigned flip : {0x01U, 0x80U, 0xFFU}) {
      bytes.data()[i] = static_cast<std::uint8_t>(bytes.data()[i] ^ flip);
      ASSERT_EQ(open(bytes).status, Status::bad_scene) << "byte " << i;
      bytes.data()[i] = static_cast<std::uint8_t>(bytes.data()[i] ^ flip);
    }
  }
  EXPECT_TRUE(open(bytes).ok());
}

// With the sum repaired a change may be harmless; what is then accepted must stay inside its own bytes, which the
// sanitised build of this test sees.
TEST_P(SceneOpen, EveryChangedByteWithRightSumIsSafeToUse) {
  const SceneBytes whole = data_of(room()).bytes();
  SceneBytes bytes = whole;
  int accepted = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const unsigned flip : {0x01U, 0x10U, 0x80U, 0xFFU}) {
      bytes.data()[i] = static_cast<std::uint8_t>(bytes.data()[i] ^ flip);
      bytes.repair_crc();
      Scene scene;
      if (Scene::open(bytes.data(), bytes.size(), scene).ok()) {
        ++accepted;
        for (Index t = 0; t < scene.triangle_count(); ++t) {
          for (int k = 0; k < 3; ++k) {
            ASSERT_TRUE(scene.inside_bounds(scene.corner(t, k)));
            if (scene.neighbor(t, k) != kNone) {
              ASSERT_LT(scene.neighbor(t, k), scene.triangle_count());
              ASSERT_LT(scene.portal(t, k), scene.portal_count());
            }
          }
        }
        for (Index p = 0; p < scene.piece_count(); ++p) ASSERT_LE(scene.piece(p).count, 8);
        for (Index g = 0; g < scene.goal_count(); ++g) ASSERT_LT(std::strlen(scene.goal_name(g)), 100U);
        for (int n = 0; n < 50; ++n) {
          const Box b = scene.bounds();
          const Vec2 p{b.min.x + (b.max.x - b.min.x) * static_cast<float>(n) / 49.0F, b.max.y};
          ASSERT_GE(scene.clearance().at(p), 0.0F);
        }
      }
      bytes.data()[i] = whole.data()[i];
    }
  }
  EXPECT_GT(accepted, 0);
}

TEST_P(SceneOpen, FailureLeavesTheSceneAlone) {
  const OpenScene good(room());
  Scene scene = good.scene;
  SceneBytes bad = data_of(room()).bytes();
  bad.data()[bad.size() - 1] ^= 1U;
  EXPECT_FALSE(Scene::open(bad.data(), bad.size(), scene).ok());
  EXPECT_EQ(scene.triangle_count(), good.scene.triangle_count());
  EXPECT_EQ(scene.corner(0, 1).x, good.scene.corner(0, 1).x);
}

TEST_P(SceneOpen, AlignedTo4IsEnough) {
  const SceneBytes whole = data_of(room()).bytes();
  SceneBytes shifted(whole.size() + 8);
  Scene scene;
  std::memcpy(shifted.data() + 4, whole.data(), whole.size());
  EXPECT_TRUE(Scene::open(shifted.data() + 4, whole.size(), scene).ok());
  for (const std::size_t shift : {1U, 2U, 3U}) {
    std::memcpy(shifted.data() + shift, whole.data(), whole.size());
    EXPECT_EQ(Scene::open(shifted.data() + shift, whole.size(), scene).status, Status::bad_scene);
  }
}

INSTANTIATE_TEST_SUITE_P(IndexWidth, SceneOpen, ::testing::Values(2, 4));

TEST(SceneOpenEdges, NothingAtAll) {
  Scene scene;
  EXPECT_EQ(Scene::open(nullptr, 0, scene).status, Status::bad_scene);
  EXPECT_EQ(Scene::open(nullptr, 1000, scene).status, Status::bad_scene);
  const SceneBytes some(8);
  EXPECT_EQ(Scene::open(some.data(), 0, scene).status, Status::bad_scene);
}

TEST(SceneOpenEdges, SceneWithoutTrianglesGoalsOrPiecesIsSound) {
  Room room;
  room.bounds = {0, 0, 2, 2};
  room.boxes = {{0, 0, 2, 2}};
  const OpenScene blocked(room);
  EXPECT_EQ(blocked.scene.triangle_count(), 0U);
  room.boxes.clear();
  const OpenScene open(room);
  EXPECT_EQ(open.scene.piece_count(), 0U);
  EXPECT_EQ(open.scene.goal_count(), 0U);
}

// From centimetres to kilometres, in any order of vertices; in grid steps the areas are exact in double.
TEST(SceneOpenEdges, AGoalIsTakenExactlyWhereItsAreaIsPositive) {
  Room room;
  room.bounds = {0, 0, 2, 2};
  room.goals = {{0, 0, 1, 1}};
  SceneData data = data_of(room);
  std::mt19937 random(1);
  int taken = 0;
  constexpr int kGoals = 2000;
  for (int i = 0; i < kGoals; ++i) {
    std::vector<Vec2>& goal = data.goals[0];
    goal.resize(3 + below(random, 8));
    const double size = std::pow(10.0, uniform(random, -2, 3.2));
    for (Vec2& v : goal) v = {snap(uniform(random, -size, size)), snap(uniform(random, -size, size))};
    double twice_area = 0;
    for (std::size_t k = 0; k < goal.size(); ++k) {
      const Point a = point(goal[k]), b = point(goal[(k + 1) % goal.size()]);
      twice_area += 4096 * a.x * 4096 * b.y - 4096 * b.x * 4096 * a.y;
    }
    const SceneBytes bytes = data.bytes();
    Scene scene;
    const Failure failure = Scene::open(bytes.data(), bytes.size(), scene);
    ASSERT_EQ(failure.ok(), twice_area > 0) << i << " " << twice_area;
    if (!failure.ok()) {
      ASSERT_EQ(int{failure.section}, int{static_cast<std::uint8_t>(format::Section::goal_vertices)});
    }
    taken += failure.ok() ? 1 : 0;
  }
  EXPECT_GT(taken, kGoals / 4);
  EXPECT_LT(taken, kGoals - kGoals / 4);
}

// UTF-8 by its definition, of code points that it has and of those that it has not.
std::string utf8(std::uint32_t code) {
  const auto tail = [code](unsigned shift) { return static_cast<char>(0x80U + ((code >> shift) & 0x3FU)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0U + (code >> 6U)), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0U + (code >> 12U)), tail(6), tail(0)};
  return {static_cast<char>(0xF0U + (code >> 18U)), tail(12), tail(6), tail(0)};
}

bool opens_with_name(const std::string& name) {
  Room room;
  room.bounds = {0, 0, 2, 2};
  SceneData data = data_of(room);
  data.names[0] = name;
  const SceneBytes bytes = data.bytes();
  Scene scene;
  if (!Scene::open(bytes.data(), bytes.size(), scene).ok()) return false;
  EXPECT_EQ(scene.name(), name);
  return true;
}

TEST(SceneOpenEdges, NamesAreTakenWithEveryPrintedCharacterOfUnicode) {
  for (const auto& [first, last] : std::initializer_list<std::pair<std::uint32_t, std::uint32_t>>{{0x20, 0x7E},
                                                                                                  {0xA0, 0x61B},
                                                                                                  {0x61D, 0x200D},
                                                                                                  {0x2010, 0x2027},
                                                                                                  {0x202F, 0x2065},
                                                                                                  {0x206A, 0xD7FF},
                                                                                                  {0xE000, 0x10FFFF}}) {
    std::string all;
    for (std::uint32_t code = first; code <= last; ++code) all += utf8(code);
    EXPECT_TRUE(opens_with_name(all)) << first;
  }
}

TEST(SceneOpenEdges, NamesAreRefusedWithWhatIsNoCharacterOrIsNotPrinted) {
  for (const auto& [first, last] :
       std::initializer_list<std::pair<std::uint32_t, std::uint32_t>>{{1, 0x1F},
                                                                      {0x7F, 0x9F},
                                                                      {0x61C, 0x61C},
                                                                      {0x200E, 0x200F},
                                                                      {0x2028, 0x202E},
                                                                      {0x2066, 0x2069},
                                                                      {0xD800, 0xDFFF},
                                                                      {0x110000, 0x110100},
                                                                      {0x13FFF0, 0x13FFFF}}) {
    for (std::uint32_t code = first; code <= last; ++code) {
      ASSERT_FALSE(opens_with_name("room " + utf8(code) + "!")) << code;
    }
  }
}

TEST(SceneOpenEdges, ANameThatEndsWithinACharacterIsRefused) {
  for (const char* character : {"\xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\x90\x8D"}) {
    const std::string whole = character;
    ASSERT_TRUE(opens_with_name(whole));
    for (std::size_t bytes = 1; bytes < whole.size(); ++bytes) {
      EXPECT_FALSE(opens_with_name(whole.substr(0, bytes))) << bytes << " of " << whole.size();
    }
  }
}

}  // namespace
}  // namespace krait::test::scene_open_test
