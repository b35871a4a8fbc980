// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>

#include "../ring_area.hpp"
#include "../scratch.hpp"
#include "host/import/import.hpp"

namespace krait::host::import_native_test {
namespace {

using testing::HasSubstr;

class NativeTest : public ScratchTest {
 protected:
  // A document with the members after its bounds.
  Workspace read(const std::string& members) const {
    const std::string comma = members.empty() ? "" : ", ";
    return import_workspace(write("s.json", R"({"bounds": {"min": [0, 0], "max": [10, 10]})" + comma + members + "}"),
                            {});
  }
  std::string error(const std::string& members) const {
    return error_of([&] { read(members); });
  }
};

double distance_to_edges(const Ring& ring, const Point& p) {
  double least = 1e300;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    least = std::min(least, ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length);
  }
  return least;
}

double distance_to_corners(const Ring& ring, const Point& p) {
  double most = 0;
  for (const Point& corner : ring) most = std::max(most, std::hypot(corner.x - p.x, corner.y - p.y));
  return most;
}

TEST_F(NativeTest, TakesItsNameFromTheFileIfItHasNone) {
  EXPECT_EQ(read("").name, "s");
  EXPECT_EQ(read(R"("name": "yard")").name, "yard");
}

TEST_F(NativeTest, WarnsOfHeadingsThatMayBeDegrees) {
  const std::string goal = R"("goals": [{"name": "g", "position": [5, 5], "radius": 1, "heading": )";
  const std::string start = R"(}], "starts": [{"name": "s", "position": [1, 1], "heading": )";
  EXPECT_THAT(read(goal + "-6.28" + start + "6.28}]").warnings, testing::IsEmpty());
  const std::string meant = " radians is more than a whole turn; were degrees meant? ";
  EXPECT_THAT(read(goal + "-45" + start + "90}]").warnings,
              testing::ElementsAre(
                  path("s.json") + ": start \"s\": a heading of 90" + meant + "90 degrees are 1.5708 radians",
                  path("s.json") + ": goal \"g\": a heading of -45" + meant + "-45 degrees are -0.7854 radians"));
}

TEST_F(NativeTest, RefusesAnglesThatAreDegrees) {
  const std::string box = R"("obstacles": [{"box": {"center": [2, 2], "size": [1, 2], "angle": )";
  EXPECT_EQ(read(box + "-6.28}}]").obstacles.size(), 1U);
  EXPECT_EQ(error(box + "90}}]"),
            path("s.json") +
                ": obstacles[0].box.angle: an angle of 90 radians is more than a whole turn; were "
                "degrees meant? 90 degrees are 1.5708 radians");
}

TEST_F(NativeTest, TakesNamesWithoutControlCharactersOnly) {
  const std::string file = path("s.json");
  const std::string expected = ": must be a name of 1 to 200 bytes without control characters, is \"a\\u202eb\"";
  const std::string name = R"("name": "a\u202Eb")";
  EXPECT_EQ(error(name), file + ": name" + expected);
  EXPECT_EQ(error(R"("goals": [{)" + name + R"(, "box": {"center": [5, 5], "size": [1, 1]}}])"),
            file + ": goals[0].name" + expected);
  EXPECT_EQ(error(R"("starts": [{)" + name + R"(, "position": [5, 5], "heading": 0}])"),
            file + ": starts[0].name" + expected);
}

TEST_F(NativeTest, AFileNameIsEscapedInTheSceneName) {
  const std::string map = R"({"bounds": {"min": [0, 0], "max": [10, 10]}})";
  EXPECT_EQ(import_workspace(write("a\x1B[m\xFF.json", map), {}).name, "a\\u001B[m\\xFF");
}

TEST_F(NativeTest, AFileNameIsEscapedInMessages) {
  EXPECT_THAT(error_of([&] { import_workspace(path("a\xE2\x80\xAE.json"), {}); }),
              testing::EndsWith("/a\\u202E.json: cannot be read: No such file or directory"));
}

TEST_F(NativeTest, IsRecognisedByContentToo) {
  EXPECT_EQ(import_workspace(write("yard", "\n {\"bounds\": {\"min\": [0,0], \"max\": [1,2]}}"), {}).max.y, 2);
}

TEST_F(NativeTest, KeepsPolygonsAndHolesAsTheyAre) {
  const Workspace w = read(R"("obstacles": [{"polygon": [[0,0],[4,0],[4,4],[0,4]], "holes": [[[1,1],[1,2],[2,2]]]}])");
  ASSERT_EQ(w.obstacles.size(), 1U);
  EXPECT_EQ(w.obstacles[0].label, "obstacles[0]");
  EXPECT_EQ(area(w.obstacles[0].outer), 16);
  ASSERT_EQ(w.obstacles[0].holes.size(), 1U);
  EXPECT_EQ(area(w.obstacles[0].holes[0]), -0.5);
}

TEST_F(NativeTest, TurnsABoxAboutItsCentre) {
  const Workspace w =
      read(R"("obstacles": [{"box": {"center": [5, 6], "size": [4, 2], "angle": 1.5707963267948966}}])");
  const Ring& ring = w.obstacles[0].outer;
  EXPECT_NEAR(area(ring), 8, 1e-12);
  EXPECT_NEAR(ring[0].x, 6, 1e-12);  // the corner (-2, -1) turned to (1, -2)
  EXPECT_NEAR(ring[0].y, 4, 1e-12);
}

TEST_F(NativeTest, ACircularObstacleIsContainedInItsPolygon) {
  for (const double radius : {1e-6, 0.05, 0.5, 3.0, 40.0, 1e6}) {
    const Workspace w =
        read(R"("obstacles": [{"circle": {"center": [3, 4], "radius": )" + std::to_string(radius) + "}}]");
    const double read_radius = std::stod(std::to_string(radius));
    const Ring& ring = w.obstacles[0].outer;
    EXPECT_GE(distance_to_edges(ring, {3, 4}), read_radius);
    EXPECT_LE(ring.size(), 128U);
    EXPECT_LE(distance_to_corners(ring, {3, 4}), radius < 30 ? read_radius + 0.0101 : read_radius * 1.001);
  }
}

TEST_F(NativeTest, ACircularGoalContainsItsPolygon) {
  for (const double radius : {0.05, 0.5, 3.0, 40.0}) {
    const Workspace w =
        read(R"("goals": [{"name": "g", "circle": {"center": [3, 4], "radius": )" + std::to_string(radius) + "}}]");
    const Ring& ring = w.goals[0].polygon;
    EXPECT_LE(distance_to_corners(ring, {3, 4}), radius);
    EXPECT_GE(distance_to_edges(ring, {3, 4}), radius < 30 ? radius - 0.0101 : radius * 0.999);
  }
}

TEST_F(NativeTest, ReadsGoalsAndStarts) {
  const Workspace w = read(R"("goals": [{"name": "a", "box": {"center": [1, 1], "size": [1, 1]}},
                                        {"name": "b", "polygon": [[0,0],[1,0],[0,1]]}],
                              "starts": [{"name": "home", "position": [2, 3], "heading": -1.5, "angles": [1, 2]}])");
  ASSERT_EQ(w.goals.size(), 2U);
  EXPECT_EQ(w.goals[1].name, "b");
  ASSERT_EQ(w.starts.size(), 1U);
  EXPECT_EQ(w.starts[0].position.y, 3);
  EXPECT_EQ(w.starts[0].heading, -1.5);
  EXPECT_EQ(w.starts[0].angles, (std::vector<double>{1, 2}));
}

TEST_F(NativeTest, AGoalMayHaveAHeading) {
  const Workspace w = read(R"("goals": [
      {"name": "a", "position": [3, 4], "radius": 0.25, "heading": -1.5},
      {"name": "b", "circle": {"center": [7, 2], "radius": 0.5}, "heading": 2, "heading_tolerance": 0.3,
       "either_way": true, "hitch_tolerance": 0.2},
      {"name": "c", "circle": {"center": [5, 5], "radius": 1}}])");
  ASSERT_TRUE(w.goals[0].pose && w.goals[1].pose);
  const GoalPose& a = *w.goals[0].pose;
  EXPECT_EQ(a.position.y, 4);
  EXPECT_EQ(a.radius, 0.25);
  EXPECT_EQ(a.facing.heading, -1.5);
  EXPECT_EQ(a.facing.tolerance, 0.1);
  EXPECT_FALSE(a.facing.either_way);
  EXPECT_FALSE(a.facing.hitches);
  for (const Point& p : w.goals[0].polygon) EXPECT_NEAR(std::hypot(p.x - 3, p.y - 4), 0.25, 1e-6);
  const GoalPose& b = *w.goals[1].pose;
  EXPECT_EQ(b.position.x, 7);
  EXPECT_EQ(b.radius, 0.5);
  EXPECT_EQ(b.facing.tolerance, 0.3);
  EXPECT_TRUE(b.facing.either_way);
  EXPECT_EQ(b.facing.hitches, 0.2);
  EXPECT_FALSE(w.goals[2].pose);
}

TEST_F(NativeTest, AHeadingThatCannotBeUsedIsRefused) {
  const auto refused = [this](const std::string& members) {
    return error(R"("goals": [{"name": "g", )" + members + "}]");
  };
  const std::string circle = R"("circle": {"center": [5, 5], "radius": 1}, )";
  const std::string pose = R"("position": [5, 5], "radius": 1, "heading": 1, )";
  EXPECT_THAT(refused(R"("position": [5, 5], "radius": 1)"),
              HasSubstr("goals[0]: position and radius need a heading; without one, give a circle"));
  EXPECT_THAT(refused(R"("position": [5, 5], "heading": 1)"), HasSubstr("goals[0].radius: is missing"));
  EXPECT_THAT(refused(R"("radius": 1, "heading": 1)"), HasSubstr("goals[0].position: is missing"));
  EXPECT_THAT(refused(pose + R"("polygon": [[1, 1], [2, 1], [2, 2]])"),
              HasSubstr("goals[0]: must have one of polygon"));
  EXPECT_THAT(refused(R"("polygon": [[1, 1], [2, 1], [2, 2]], "heading": 1)"),
              HasSubstr("goals[0].heading: needs a circle, or position and radius"));
  EXPECT_THAT(refused(circle + R"("heading": "north")"), HasSubstr("goals[0].heading: must be a number from -1000"));
  EXPECT_THAT(refused(circle + R"("either_way": true)"), HasSubstr("goals[0].either_way: needs a heading beside it"));
  EXPECT_THAT(refused(pose + R"("heading_tolerance": 0)"),
              HasSubstr("goals[0].heading_tolerance: must be a number from 0.0001 to 3.1415927 radians, is 0"));
  EXPECT_THAT(refused(pose + R"("hitch_tolerance": 4)"), HasSubstr("goals[0].hitch_tolerance: must be a number from"));
  EXPECT_THAT(refused(pose + R"("either_way": 1)"), HasSubstr("goals[0].either_way: must be true or false, is 1"));
}

TEST_F(NativeTest, UnknownKeysAreNamed) {
  EXPECT_THAT(error(R"("obstacels": [])"), HasSubstr("unknown key \"obstacels\"; known here: name, bounds, obstacles"));
  EXPECT_THAT(error(R"("obsta\ncles": [])"), HasSubstr("unknown key \"obsta\\u000Acles\""))
      << "found by fuzzing: two lines";
  EXPECT_THAT(error(R"("a\u001bb": 1, "a\u001bb": 2)"), HasSubstr("key \"a\\u001Bb\" is given twice"));
  EXPECT_THAT(error(R"("obstacles": [{"polygon": [[0,0],[1,0],[0,1]], "hole": []}])"),
              HasSubstr("obstacles[0]: unknown key \"hole\""));
  EXPECT_THAT(error(R"("goals": [{"name": "g", "circle": {"centre": [1,1], "radius": 1}}])"),
              HasSubstr("goals[0].circle: unknown key \"centre\""));
  EXPECT_THAT(error(R"("starts": [{"name": "s", "pose": 1}])"), HasSubstr("starts[0]: unknown key \"pose\""));
}

TEST_F(NativeTest, WrongValuesAreNamed) {
  EXPECT_THAT(error(R"("obstacles": [{"circle": {"center": [1, 1], "radius": 0}}])"),
              HasSubstr("obstacles[0].circle.radius"));
  EXPECT_THAT(error(R"("obstacles": [{"circle": {"center": [1, 2e10], "radius": 1}}])"), HasSubstr("circle.center[1]"));
  EXPECT_THAT(error(R"("obstacles": [{"box": {"center": [1, 1], "size": [1, -1]}}])"), HasSubstr("box.size[1]"));
  EXPECT_THAT(error(R"("obstacles": [{"box": {"center": [1, 1], "size": 1}}])"), HasSubstr("box.size: must be a list"));
  EXPECT_THAT(error(R"("obstacles": [{"polygon": [[0,0],[1,1]]}])"), HasSubstr("at least 3"));
  EXPECT_THAT(error(R"("obstacles": [{"polygon": [[0,0],[1,1],[2]]}])"), HasSubstr("polygon[2]: must be [x, y]"));
  EXPECT_THAT(error(R"("obstacles": [{}])"), HasSubstr("must have one of polygon, box and circle, has 0"));
  EXPECT_THAT(error(R"("obstacles": [{"box": {}, "circle": {}}])"), HasSubstr("has 2"));
  EXPECT_THAT(error(R"("obstacles": [{"circle": {"center": [1,1], "radius": 1}, "holes": []}])"),
              HasSubstr("only a polygon"));
  EXPECT_THAT(error(R"("obstacles": {})"), HasSubstr("obstacles: must be a list, is an object of 0"));
  EXPECT_THAT(error(R"("goals": [{"polygon": [[0,0],[1,0],[0,1]]}])"), HasSubstr("goals[0].name: is missing"));
  EXPECT_THAT(error(R"("starts": [{"name": "s", "position": [1,1], "heading": 1e300}])"),
              HasSubstr("starts[0].heading"));
  EXPECT_THAT(error(R"("starts": [{"name": "s", "position": [1,1], "heading": 0},
                                  {"name": "s", "position": [1,2], "heading": 0}])"),
              HasSubstr("the name \"s\" is given twice"));
}

TEST_F(NativeTest, UnusableBoundsAreRefused) {
  const auto bounds = [&](const std::string& text) {
    return error_of([&] { import_workspace(write("s.json", R"({"bounds": )" + text + "}"), {}); });
  };
  EXPECT_THAT(bounds(R"({"min": [0, 0], "max": [0, 1]})"), HasSubstr("bounds: max must be greater than min"));
  EXPECT_THAT(bounds(R"({"min": [0, 0], "max": [NaN, 1]})"), HasSubstr("is not valid JSON"));
  EXPECT_THAT(bounds(R"({"min": [0, 0], "max": [1e300, 1]})"), HasSubstr("bounds.max[0]: must be a number"));
  EXPECT_THAT(bounds(R"({"min": [0, 0]})"), HasSubstr("bounds.max: is missing"));
  EXPECT_THAT(error_of([&] { import_workspace(write("s.json", "{}"), {}); }), HasSubstr("bounds: is missing"));
}

}  // namespace
}  // namespace krait::host::import_native_test
