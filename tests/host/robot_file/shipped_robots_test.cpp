// SPDX-License-Identifier: Apache-2.0
// The shipped robots' files, and what a ROBOT.json may say for its reader only.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "../scratch.hpp"
#include "host/robot_file/robot_file.hpp"
#include "host/robot_file/shipped.hpp"

namespace krait::host::shipped_robots_test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

RobotSpec read(const std::string& json) {
  const Json document = parse_json(json, "r.json");
  return read_robot(Field(document, "r.json"));
}

std::string read_error(const std::string& json) {
  return error_of([&] { read(json); });
}

TEST(ShippedRobots, AreRealMachinesOfEveryKind) {
  EXPECT_THAT(shipped_robots(), SizeIs(testing::Ge(8)));
  std::set<std::string> names;
  std::set<int> trailers;
  for (const ShippedRobot& shipped : shipped_robots()) {
    EXPECT_TRUE(names.insert(shipped.name).second) << shipped.name;
    trailers.insert(parse_robot(shipped.name).links);
  }
  EXPECT_THAT(names, testing::IsSupersetOf({"turtlebot3_burger", "turtlebot4", "f1tenth", "fork_lift", "semitrailer"}));
  EXPECT_THAT(trailers, testing::IsSupersetOf({0, 1, 2, 3}));
}

// Every number that a file states, and every one that it leaves at a model's default, has a source, and says of which
// kind it is; a robot without trailers needs none for what only trailers have.
TEST(ShippedRobots, NameTheSourceOfEveryNumber) {
  const std::set<std::string> of_trailers = {"hitch_length", "max_hitch_angle", "self_collision_gap"};
  const std::set<std::string> of_boxes = {"body_length", "body_width"};
  for (const ShippedRobot& shipped : shipped_robots()) {
    const RobotSpec robot = parse_robot(shipped.name);
    EXPECT_NE(robot.about, "") << shipped.name;
    const bool boxed = robot.sources.count("bodies") == 0;
    for (const auto& [name, value] : robot.parameters) {
      const bool left_out = (robot.links == 0 && of_trailers.count(name) > 0) || (!boxed && of_boxes.count(name) > 0);
      EXPECT_TRUE(left_out || robot.sources.count(name) == 1) << shipped.name << ": " << name;
    }
    for (const auto& [name, source] : robot.sources) {
      EXPECT_THAT(source, AnyOf(StartsWith("published: "), StartsWith("derived: "), StartsWith("assumed: ")))
          << shipped.name << ": " << name;
    }
  }
}

TEST(ShippedRobots, AreNoFiles) {
  for (const char* name : {"turtlebot4", "semitrailer", "car", "snake:15"}) EXPECT_FALSE(is_robot_file(name)) << name;
  for (const char* path : {"./turtlebot4", "turtlebot4.json", "mine.json"}) EXPECT_TRUE(is_robot_file(path)) << path;
}

TEST(ShippedRobots, AnUnknownNameIsToldThem) {
  const auto unknown = [](const char* name) { return error_of([&] { parse_robot(name); }); };
  const std::string error = unknown("turtlebot5");
  EXPECT_THAT(error, HasSubstr("unknown robot \"turtlebot5\"; is turtlebot4 meant? Known are snake:N"));
  EXPECT_THAT(unknown("turtlebot"), HasSubstr("\"; is turtlebot3_burger or turtlebot4 meant? Known are "));
  EXPECT_THAT(unknown("trukc:2"), HasSubstr("\"; is truck meant? Known are "));
  EXPECT_THAT(unknown("tank"), HasSubstr("unknown robot \"tank\"; known are "));
  for (const ShippedRobot& shipped : shipped_robots()) EXPECT_THAT(error, HasSubstr(shipped.name));
}

TEST(RobotRemarks, AreReadAndNotWritten) {
  const RobotSpec robot =
      read(R"({"about": "mine", "model": "car", "sources": {"wheelbase": "measured", "bodies": "b"}})");
  EXPECT_EQ(robot.about, "mine");
  EXPECT_EQ(robot.sources.at("wheelbase"), "measured");
  EXPECT_EQ(to_json(robot), to_json(parse_robot("car")));
}

TEST(RobotRemarks, ErrorsNameTheField) {
  EXPECT_THAT(read_error(R"({"model": "car", "about": 3})"), HasSubstr("r.json: about: must be"));
  EXPECT_THAT(read_error(R"({"model": "car", "about": "a\u001b[2J"})"), HasSubstr("about"));
  EXPECT_THAT(read_error(R"({"model": "car", "sources": ["x"]})"), HasSubstr("or bodies, is a list of 1"));
  EXPECT_THAT(read_error(R"({"model": "car", "sources": {"track_width": "x"}})"),
              HasSubstr("sources: \"track_width\" is no parameter of a car"));
  EXPECT_THAT(read_error(R"({"model": "car", "sources": {"wheelbase": 1}})"), HasSubstr("sources.wheelbase"));
}

TEST(RobotUnits, AreThoseOfTheParameters) {
  EXPECT_EQ(unit_of("car", "wheelbase"), "metres");
  EXPECT_EQ(unit_of("diff_drive", "max_wheel_speed"), "radians a second");
  EXPECT_EQ(unit_of("car", "track_width"), "");
}

}  // namespace
}  // namespace krait::host::shipped_robots_test
