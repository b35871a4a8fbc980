// SPDX-License-Identifier: GPL-3.0-or-later
// The program: exit codes, one line of complaint, a file whole or not at all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "paths.hpp"
#include "scene_view.hpp"

namespace krait::host::test {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int code;
  std::string errors;
};

class KraitCompile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("krait_compile_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    std::ofstream(folder_ / "room.json") << R"({"name": "room", "bounds": {"min": [0, 0], "max": [20, 20]},
        "obstacles": [{"box": {"center": [10, 10], "size": [2, 2], "angle": 0}}],
        "goals": [{"name": "dock", "polygon": [[1, 1], [3, 1], [3, 3], [1, 3]]}],
        "starts": [{"name": "home", "position": [5, 5], "heading": 0}]})";
  }
  void TearDown() override { fs::remove_all(folder_); }

  Outcome run(const std::string& arguments) const {
    const std::string log = (folder_ / "log").string();
    const int status =
        std::system((krait::test::program_path("krait-compile") + " " + arguments + " >" + log + " 2>&1").c_str());
    std::ostringstream text;
    text << std::ifstream(log).rdbuf();
    return {WEXITSTATUS(status), text.str()};
  }
  std::string path(const char* name) const { return (folder_ / name).string(); }

  // Of arguments that are taken without a word.
  SceneView compiled(const std::string& arguments) const {
    const Outcome outcome = run(arguments + " -o " + path("out.krait"));
    EXPECT_EQ(outcome.code, 0) << arguments;
    EXPECT_EQ(outcome.errors, "") << arguments;
    std::ifstream in(path("out.krait"), std::ios::binary);
    return Reader(std::vector<std::uint8_t>{std::istreambuf_iterator<char>(in), {}}).read();
  }

  void expect_refused(const std::string& arguments, const std::string& mention) const {
    const Outcome outcome = run(arguments + " -o " + path("out.krait"));
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_THAT(outcome.errors, testing::HasSubstr(mention));
    EXPECT_FALSE(fs::exists(path("out.krait")));
  }

  fs::path folder_;
};

TEST_F(KraitCompile, AStartWhereTheRobotHasNoRoomIsNamed) {
  const std::string robot = path("room.json") + " --cell 0.1 --for husky";
  expect_refused(robot + " --start 8.6,10,0",
                 "--start: the robot of --for cannot begin at start 'start': the robot overlaps an obstacle (piece ");
  EXPECT_THAT(run(robot + " --start 5,5,0 -o " + path("out.krait")).errors, testing::Not(testing::HasSubstr("begin")));
  std::ofstream(path("walled.json")) << R"({"bounds": {"min": [0, 0], "max": [20, 20]}, "obstacles": [],
      "starts": [{"name": "home", "position": [0.2, 5], "heading": 0}]})";
  const Outcome outcome = run(path("walled.json") + " --for husky -o " + path("out.krait"));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.errors, testing::HasSubstr("warning: the robot of --for cannot begin at start 'home': "));
}

// Two walls with a door of 0.85 m between them, which cells of 0.5 m leave 0.5 m of: one cell, which is not closed.
TEST_F(KraitCompile, AGoalThatTheRobotCannotComeToIsNamed) {
  std::ofstream(path("door.json")) << R"({"bounds": {"min": [0, 0], "max": [12, 12]},
      "obstacles": [{"box": {"center": [6.2, 2.95], "size": [0.4, 5.9], "angle": 0}},
                    {"box": {"center": [6.2, 9.375], "size": [0.4, 5.25], "angle": 0}}],
      "goals": [{"name": "near", "box": {"center": [3, 9], "size": [1, 1], "angle": 0}},
                {"name": "far", "box": {"center": [10, 6], "size": [1, 1], "angle": 0}}],
      "starts": [{"name": "home", "position": [3, 6], "heading": 0}]})";
  const auto said = [&](const std::string& options) {
    const Outcome outcome = run(path("door.json") + " --for husky -o " + path("out.krait") + options);
    EXPECT_EQ(outcome.code, 0);
    return outcome.errors;
  };
  const std::string warned = "krait-compile: warning: the robot of --for cannot come to goal 'far': every way to the ";
  EXPECT_THAT(said(" --cell 0.5"),
              testing::AllOf(testing::HasSubstr(warned), testing::Not(testing::HasSubstr("'near'"))));
  EXPECT_THAT(said(" --cell 0.5 --any-start"), testing::Not(testing::HasSubstr("of --for")));
  EXPECT_THAT(said(" --cell 0.02"), testing::Not(testing::HasSubstr("of --for")));
}

// A goal beside an obstacle: there is no room in the triangles next to it, and enough in the others.
TEST_F(KraitCompile, ABudgetIsUsedWhereOnlyAPartOfTheGoalHasRoom) {
  const std::string robot = path("room.json") + " --cell 0.1 --for husky --flash 1M --start 5,5,0";
  for (const char* goal :
       {" --goal 10,11.4,0.35", " --goal 11.4,10,0.35", " --goal 10,8.6,0.35", " --goal 8.6,10,0.35"}) {
    const Outcome outcome = run(robot + goal + " -o " + path("out.krait"));
    EXPECT_THAT(outcome.errors, testing::StartsWith("krait-compile: obstacles as they are\n")) << goal;
  }
}

TEST_F(KraitCompile, AStartInAnObstacleIsNamed) {
  const std::string to_file = " -o " + path("out.krait");
  const std::string warning = "krait-compile: warning: start 'start' lies in an obstacle: no plan can begin there";
  const std::string blocked = path("room.json") + " --start 10,10,0";
  EXPECT_EQ(run(blocked + to_file).errors, warning + "\n");
  EXPECT_EQ(run(blocked + " --tolerance 0.1" + to_file).errors,
            warning + " (obstacles are grown by up to 0.05 m: --tolerance 0 leaves them as they are)\n");
  std::ofstream(path("post.map")) << "type octile\nheight 3\nwidth 3\nmap\n...\n.@.\n...\n";
  EXPECT_EQ(run(path("post.map") + " --start 1.5,1.5,0" + to_file).errors, warning + "\n");
  compiled(blocked + " --any-start");
  compiled(path("room.json") + " --start 5,5,0");
}

TEST_F(KraitCompile, StartReplacesAndGoalJoinsTheFiles) {
  const SceneView v = compiled(path("room.json") + " --start 4,4,0.5 --goal 15,15,1");
  EXPECT_THAT(v.names, testing::ElementsAre("room", "dock", "goal", "start"));
  for (const Point p : v.goals.at(1)) EXPECT_LE(std::hypot(p.x - 15, p.y - 15), 1);
}

TEST_F(KraitCompile, AGoalReplacesTheFilesOfItsName) {
  std::ofstream(path("goal.json")) << R"({"bounds": {"min": [0, 0], "max": [20, 20]},
      "goals": [{"name": "goal", "polygon": [[1, 1], [3, 1], [3, 3], [1, 3]]}]})";
  const SceneView v = compiled(path("goal.json") + " --goal 15,15,1");
  ASSERT_EQ(v.goals.size(), 1U);
  for (const Point p : v.goals[0]) EXPECT_LE(std::hypot(p.x - 15, p.y - 15), 1);
}

TEST_F(KraitCompile, QuietIsWithoutWarnings) {
  std::ofstream(path("far.json")) << R"({"bounds": {"min": [0, 0], "max": [20, 20]},
      "starts": [{"name": "home", "position": [30, 5], "heading": 0}]})";
  EXPECT_THAT(run(path("far.json") + " -o " + path("out.krait")).errors,
              testing::HasSubstr("warning: start 'home' lies outside"));
  compiled(path("far.json") + " --quiet");
}

TEST_F(KraitCompile, AMapThatIsRefusedHasItsWarningsBefore) {
  std::ofstream(path("one.geojson")) << R"({"type": "Polygon", "unit": 1,
      "coordinates": [[[0, 0], [10, 0], [10, 5], [0, 5], [0, 0]]]})";
  const std::string refused = path("one.geojson") + " -o " + path("out.krait");
  const std::string full =
      "krait-compile: no free space is left: obstacles cover all of the bounds, 0,0 to 10,5 m: is one of the shapes "
      "meant as the bounds, or are these too small?\n";
  const std::string warning =
      "krait-compile: warning: " + path("one.geojson") + ": has no bounds; they are the box around all its shapes\n";
  EXPECT_EQ(run(refused).errors, warning + full);
  EXPECT_THAT(run(refused + " --cell 30").errors,
              testing::StartsWith(warning + "krait-compile: --cell 30: the map is"));
  EXPECT_EQ(run(refused + " --quiet").errors, full);
  std::ofstream(path("full.map")) << "type octile\nheight 2\nwidth 2\nmap\n@@\n@@\n";
  expect_refused(path("full.map"),
                 "no free space is left: obstacles cover all of the bounds, 0,0 to 2,2 m: are unknown cells free (see "
                 "--unknown), or free and occupied values exchanged?");
}

// Behind a door of 30 cm.
TEST_F(KraitCompile, ARoomThatTheRobotCannotEnterIsClosedWhereThereAreCells) {
  std::ofstream(path("door.json")) << R"({"bounds": {"min": [0, 0], "max": [20, 20]},
      "obstacles": [{"box": {"center": [10, 7], "size": [6.4, 0.4], "angle": 0}},
                    {"box": {"center": [10, 13], "size": [6.4, 0.4], "angle": 0}},
                    {"box": {"center": [7, 10], "size": [0.4, 6.4], "angle": 0}},
                    {"box": {"center": [13, 8.4], "size": [0.4, 2.9], "angle": 0}},
                    {"box": {"center": [13, 11.6], "size": [0.4, 2.9], "angle": 0}}],
      "starts": [{"name": "home", "position": [3, 3], "heading": 0}]})";
  const auto is_open = [&](const std::string& options) {
    const SceneView v = compiled(path("door.json") + options);
    const auto holds_the_middle = [](const Ring& triangle) { return convex_contains(triangle, {10, 10}); };
    return std::any_of(v.triangles.begin(), v.triangles.end(), holds_the_middle);
  };
  EXPECT_TRUE(is_open(" --cell 0.05"));
  EXPECT_FALSE(is_open(" --cell 0.05 --for husky"));
  EXPECT_TRUE(is_open(" --for husky --quiet")) << "a drawing";
  const auto warned = [&](const std::string& options) {
    return run(path("door.json") + " --for husky" + options + " -o " + path("out.krait")).errors;
  };
  EXPECT_EQ(warned(""),
            "krait-compile: warning: --for: closes nothing, since it works on cells and the map is a "
            "drawing: give --cell METRES with it\n");
  EXPECT_EQ(warned(" --cell 0.05"), "");
  EXPECT_THAT(warned(" --flash 1M"), testing::Not(testing::HasSubstr("warning")));
}

TEST_F(KraitCompile, ABudgetIsThatOfItsOption) {
  const std::string robot = path("room.json") + " --for husky";
  expect_refused(robot + " --flash 1K", " of 1024 bytes of flash");
  expect_refused(robot + " --ram 2K", " of 2048 of RAM");
  expect_refused(robot + " --flash 1K --ram 2K", " of 1024 bytes of flash");
  expect_refused(robot + " --flash 1M --ram 2K", " of 2048 of RAM");
}

TEST_F(KraitCompile, ABudgetIsToldWhatACorridorNeeds) {
  std::ofstream(path("bare.json")) << R"({"bounds": {"min": [0, 0], "max": [20, 20]}})";
  const std::string budget = " --for husky --flash 1K";
  const std::string kept = " so that a corridor may be kept\n";
  expect_refused(path("room.json") + budget, ": crop the map, or give it --cell METRES" + kept);
  expect_refused(path("room.json") + " --cell 0.1" + budget, ": crop the map\n");
  expect_refused(path("bare.json") + " --cell 0.1" + budget, ": crop the map, or give it a start and a goal" + kept);
  expect_refused(path("bare.json") + budget, ": crop the map, or give it a start and a goal and --cell METRES" + kept);
}

TEST_F(KraitCompile, ABudgetOfNothingIsRefused) {
  const std::string robot = path("room.json") + " --for husky";
  expect_refused(robot + " --flash 0", "--flash 0: give bytes above 0, as 256K or 1M, or leave it out");
  expect_refused(robot + " --flash 1M --ram 0K", "--ram 0K: give bytes above 0");
}

TEST_F(KraitCompile, BadInputIsOneLineAndNoFile) {
  expect_refused(path("missing.json"), "missing.json");
  expect_refused(path("room.json") + " --start 1,2", "--start");
  expect_refused(path("room.json") + " --start 1,2,nan", "--start");
  expect_refused(path("room.json") + " --goal 1,2,0", "--goal");
  expect_refused(path("room.json") + " --goal 100,100,1", "outside");
  expect_refused(path("room.json") + " --goal 2,2,1", "overlap");
  expect_refused(path("room.json") + " --tolerance -1", "tolerance");
  expect_refused(path("room.json") + " --unknown perhaps", "unknown");
  expect_refused(path("room.json") + " --crop 9,1,1,9", "--crop '9,1,1,9': give X0 below X1 and Y0 below Y1");
  expect_refused(path("room.json") + " --crop 1,9,9,1", "--crop '1,9,9,1': give X0 below X1 and Y0 below Y1");
}

TEST_F(KraitCompile, UnwritableOutputIsRefused) {
  const Outcome outcome = run(path("room.json") + " -o " + path("no/such/folder/out.krait"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.errors, testing::HasSubstr("cannot be written"));
}

TEST_F(KraitCompile, SampleMaps) {
  const fs::path samples = krait::test::source_path("../shared/samples");
  if (!fs::exists(samples)) GTEST_SKIP() << "no sample maps in " << samples;
  for (const char* map : {"turtlebot3/map.yaml", "nav2/depot.yaml", "nav2/tb3_sandbox.yaml", "karlkurzer/map.yaml",
                          "mir/maze.yaml", "dynobench/bugtrap_0.yaml", "movingai/den312d.map"}) {
    const Outcome outcome = run((samples / map).string() + " -o " + path("out.krait"));
    EXPECT_EQ(outcome.code, 0) << map << ": " << outcome.errors;
  }
}

}  // namespace
}  // namespace krait::host::test
