// SPDX-License-Identifier: Apache-2.0
// port/host/demo beside a build that is there already.
#include <filesystem>

#include "host/cli/program.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Demo : public CliTest {
 protected:
  // A project of the script, of a build that builds nothing, and of the programs.
  Demo() {
    fs::create_directories(path("krait/port/host"));
    fs::create_directories(path("krait/build/host/bin"));
    for (const char* file : {"port/usage", "port/host/demo"}) {
      fs::copy_file(test::source_path(file), path(std::string("krait/") + file));
    }
    write("krait/port/host/build", "");
    for (const char* program : {"krait", "krait-compile"}) {
      fs::create_symlink(test::program_path(program), path(std::string("krait/build/host/bin/") + program));
    }
  }

  Outcome demo(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), path("krait/port/host/demo"));
    return run_program("/bin/bash", arguments, directory());
  }

  bool has_plan() const { return fs::exists(path("krait/out/plan.json")); }
};

TEST_F(Demo, ExplainsItself) {
  const Outcome outcome = demo({"--help"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("bash port/host/demo MAP"));
}

TEST_F(Demo, PlansInAMapAndVerifiesAndDraws) {
  const Outcome outcome = demo({"room.json", "--robot=car", "--goal", "16,2.5,0.75", "--heading=-0.4", "--improve=0"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("planning in room.json\nsolved: car (1 body) in room, seed 1"));
  EXPECT_THAT(outcome.output, HasSubstr("verifying what was written\n"));
  EXPECT_THAT(
      outcome.output,
      HasSubstr("For firmware: krait/build/host/bin/krait compile room.json --goal 16,2.5,0.75 -o scene.krait\n"));
  EXPECT_EQ(json("krait/out/plan.json").at("robot").at("model"), "car");
  for (const char* file : {"plan.svg", "plan.png", "plan.html"}) {
    EXPECT_GT(fs::file_size(path(std::string("krait/out/") + file)), 1000U) << file;
  }
}

TEST_F(Demo, PlansInAShippedSceneWhereNoMapIsNamed) {
  const Outcome outcome = demo({"--robot=diff_drive", "--improve=0"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("solved: diff_drive (1 body) in openings"));
}

TEST_F(Demo, SaysOfASceneFileThatABoardLoadsIt) {
  EXPECT_THAT(demo({"room.krait", "--robot=car", "--improve=0"}).output,
              HasSubstr("For firmware: room.krait is what a board loads\n"));
}

TEST_F(Demo, LeavesNoEarlierPlanWhereItHasNone) {
  EXPECT_EQ(demo({"room.json", "--robot=car", "--improve=0"}).code, 0);
  EXPECT_TRUE(has_plan());
  EXPECT_EQ(demo({"room.json", "--robot=car", "--end-speed=fast"}).code, 2);
  EXPECT_FALSE(has_plan());
}

TEST_F(Demo, EndsAsTheSearchDoes) {
  const Outcome outcome = demo({"room.json", "--robot=car", "--iterations=1"});
  EXPECT_EQ(outcome.code, 1) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("how the search ended; there is no plan\n"));
}

TEST_F(Demo, RefusesAMissingMapBeforeItBuilds) {
  for (const auto& [map, line] :
       {std::pair<const char*, const char*>{"gone.yaml", "no such file"}, {".", "is a directory, not a file"}}) {
    const Outcome outcome = demo({map});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.errors, std::string("demo: ") + map + ": " + line + "\n");
    EXPECT_EQ(outcome.output, "");
  }
}

TEST_F(Demo, RefusesOptionsThatItCannotReadBeforeItBuilds) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--seed"}, {"stray"}, {"--seed=1", "stray"}}) {
    std::vector<std::string> whole = {"room.json"};
    whole.insert(whole.end(), arguments.begin(), arguments.end());
    const Outcome outcome = demo(whole);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.errors, testing::StartsWith("demo: "));
    EXPECT_THAT(outcome.errors, HasSubstr(arguments.back()));
  }
  EXPECT_EQ(demo({"--robot=car", "room.json"}).errors, "demo: room.json comes after an option: give the map first\n");
}

}  // namespace
}  // namespace krait::host
