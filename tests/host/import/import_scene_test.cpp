// SPDX-License-Identifier: Apache-2.0
// A compiled scene reads as what it was made of, and is refused where it says what no scene says.
#include <gmock/gmock.h>

#include <cstddef>

#include "../../core/scene_builder.hpp"
#include "../scratch.hpp"
#include "host/import/import.hpp"

namespace krait::host::import_scene_test {
namespace {

using format::Header;
using format::Section;
using test::SceneBytes;
using testing::HasSubstr;

SceneBytes example() {
  test::Room room;
  room.bounds = {0, 0, 4, 3};
  room.boxes = {{1, 1, 2, 2}};
  room.goals = {{3, 0, 4, 1}, {0, 2, 1, 3}};
  room.starts = {{0.5F, 0.25F, 1.5F, 0, 2}};
  room.start_angles = {1.25F, -1.0F};
  SceneBytes bytes = test::data_of(room).bytes();
  bytes.put(offsetof(Header, origin_x), 400.0);
  return bytes;
}

class SceneFileTest : public ScratchTest {
 protected:
  Workspace read(const SceneBytes& bytes) const {
    const std::string content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return import_workspace(write("room.krait", content), {});
  }

  // The error of the example with this in place of what stands there.
  template <class T>
  std::string error_with(std::size_t offset, const T& value) const {
    SceneBytes bytes = example();
    bytes.put(offset, value);
    return error_of([&] { read(bytes); });
  }
};

TEST_F(SceneFileTest, ReadsItsObstaclesGoalsAndStarts) {
  const Workspace room = read(example());
  EXPECT_EQ(room.min.x, 400);
  EXPECT_EQ(room.max.x, 404);
  EXPECT_EQ(room.max.y, 3);
  ASSERT_EQ(room.obstacles.size(), 1U);
  ASSERT_EQ(room.obstacles[0].outer.size(), 4U);
  EXPECT_EQ(room.obstacles[0].outer[0].x, 401);
  EXPECT_EQ(room.obstacles[0].outer[2].y, 2);
  ASSERT_EQ(room.goals.size(), 2U);
  EXPECT_EQ(room.goals[1].polygon.at(0).y, 2);
  EXPECT_NE(room.goals[0].name, room.goals[1].name);
  ASSERT_EQ(room.starts.size(), 1U);
  EXPECT_EQ(room.starts[0].position.x, 400.5);
  EXPECT_EQ(room.starts[0].position.y, 0.25);
  EXPECT_EQ(room.starts[0].heading, 1.5);
  EXPECT_THAT(room.starts[0].angles, testing::ElementsAre(1.25, -1));
}

TEST_F(SceneFileTest, IsRefusedWhereItSaysWhatNoSceneSays) {
  const SceneBytes bytes = example();
  const Header header = bytes.header();
  const std::size_t start = bytes.at<format::StartRecord>(Section::starts, 0);
  EXPECT_THAT(error_with(offsetof(Header, version), header.version + 1), HasSubstr("another version"));
  EXPECT_THAT(error_with(offsetof(Header, total_bytes), header.total_bytes - 4), HasSubstr("cut short"));
  EXPECT_THAT(error_with(offsetof(Header, bounds_max_x), 0.0F), HasSubstr("has no bounds"));
  EXPECT_THAT(error_with(offsetof(Header, goals), header.goals + 1), HasSubstr("wrong number of names"));
  EXPECT_THAT(error_with(bytes.at<char>(Section::names, 0), '\n'), HasSubstr("control characters"));
  for (const std::uint32_t end : {2U, format::kMaxPieceVertices + 1U}) {
    EXPECT_THAT(error_with(bytes.at<std::uint32_t>(Section::piece_offsets, 1), end), HasSubstr("too few or too many"));
  }
  EXPECT_THAT(error_with(bytes.at<float>(Section::piece_vertices, 0), 1e30F), HasSubstr("out of all bounds"));
  EXPECT_THAT(error_with(start + offsetof(format::StartRecord, heading), 1e30F), HasSubstr("an angle out of all"));
  EXPECT_THAT(error_with(start + offsetof(format::StartRecord, angle_count), 999U), HasSubstr("too many trailers"));
  EXPECT_THAT(error_with(start + offsetof(format::StartRecord, first_angle), 0xFFFF'FFFFU), HasSubstr("past its end"));
}

}  // namespace
}  // namespace krait::host::import_scene_test
