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
        std::system((std::string(KRAIT_BIN_DIR) + "/krait-compile " + arguments + " >" + log + " 2>&1").c_str());
    std::ostringstream text;
    text << std::ifstream(log).rdbuf();
    return {WEXITSTATUS(status), text.str()};
  }
  std::string path(const char* name) const { return (folder_ / name).string(); }

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

TEST_F(KraitCompile, StartReplacesAndGoalJoinsTheFiles) {
  const Outcome outcome = run(path("room.json") + " -o " + path("out.krait") + " --start 4,4,0.5 --goal 15,15,1");
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  std::ifstream in(path("out.krait"), std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
  const SceneView v = Reader(bytes).read();
  EXPECT_THAT(v.names, testing::ElementsAre("room", "dock", "goal", "start"));
  for (const Point p : v.goals.at(1)) EXPECT_LE(std::hypot(p.x - 15, p.y - 15), 1);
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
}

TEST_F(KraitCompile, UnwritableOutputIsRefused) {
  const Outcome outcome = run(path("room.json") + " -o " + path("no/such/folder/out.krait"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.errors, testing::HasSubstr("cannot be written"));
}

TEST_F(KraitCompile, SampleMaps) {
  const fs::path samples = fs::path(KRAIT_SOURCE_DIR) / "../shared/samples";
  if (!fs::exists(samples)) GTEST_SKIP() << "no sample maps in " << samples;
  for (const char* map : {"turtlebot3/map.yaml", "nav2/depot.yaml", "nav2/tb3_sandbox.yaml", "karlkurzer/map.yaml",
                          "mir/maze.yaml", "dynobench/bugtrap_0.yaml", "movingai/den312d.map"}) {
    const Outcome outcome = run((samples / map).string() + " -o " + path("out.krait"));
    EXPECT_EQ(outcome.code, 0) << map << ": " << outcome.errors;
  }
}

}  // namespace
}  // namespace krait::host::test
