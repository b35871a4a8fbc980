// SPDX-License-Identifier: Apache-2.0
// krait plan on a map: it is compiled as krait compile does it, and the plan is judged against the map itself.
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "host/cli/program.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;
using Arguments = std::vector<std::string>;

constexpr const char* kRules =
    "resolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

// 12 x 8 m, free.
std::string movingai() {
  std::string map = "type octile\nheight 8\nwidth 12\nmap\n";
  for (int row = 0; row < 8; ++row) map += "............\n";
  return map;
}

// 12 x 8 m, free, but for two columns of unknown cells in its middle.
std::string divided_image() {
  std::string image = "P2 12 8 255\n";
  for (int row = 0; row < 8; ++row) image += "255 255 255 255 255 150 150 255 255 255 255 255\n";
  return image;
}

// 12 x 12 m in cells of half a metre: a corridor of one cell that climbs like a staircase, or descends.
std::string staircase(bool descends) {
  constexpr int kSize = 24;
  std::string image = "P2 24 24 255\n";
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const int along = descends ? column : kSize - 1 - column;
      const bool free = row >= 2 && row < 20 && (along == row || along == row + 1);
      image += free ? "255 " : "0 ";
    }
    image += "\n";
  }
  return image;
}

// As large: solid below a diagonal of steps, each one cell.
std::string slope() {
  constexpr int kSize = 24;
  std::string image = "P2 24 24 255\n";
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) image += column >= row ? "255 " : "0 ";
    image += "\n";
  }
  return image;
}

constexpr const char* kHalfMetreCells =
    "image: image.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

class CliMap : public CliTest {
 protected:
  ordered_json planned(const std::string& input, const Arguments& options) const {
    Arguments arguments = {"plan", input, "-o", "plan.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_done(arguments);
    ordered_json plan = json("plan.json");
    for (const char* time : {"time_s", "improve_time_s"}) plan.at("statistics").erase(time);
    return plan;
  }

  void expect_verified(const std::string& map, const Arguments& options) const {
    planned(map, options);
    Arguments arguments = {"verify", map, "plan.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = krait(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("the plan holds"));
  }
};

const Arguments kAcross = {"--robot", "unicycle", "--start", "2.5,4,0", "--goal", "9.5,4,0.5"};

Arguments across(const Arguments& more) {
  Arguments all = kAcross;
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST_F(CliMap, HasThePlanOfTheCompiledScene) {
  for (const Arguments& query : {Arguments{"--robot", "car"}, Arguments{"--robot", "truck:2", "--start", "north"},
                                 Arguments{"--robot", "unicycle", "--goal", "south"}}) {
    EXPECT_EQ(planned("room.json", query), planned("room.krait", query));
  }
}

TEST_F(CliMap, LeavesOnlyWhatWasAskedFor) {
  const auto before = files();
  expect_done({"plan", "room.json", "--robot", "car"});
  EXPECT_EQ(files(), before);
}

TEST_F(CliMap, TakesEveryFormatOfCompile) {
  write("open.map", movingai());
  expect_verified("open.map", kAcross);
  write("image.pgm", divided_image());
  write("ros.yaml", std::string("image: image.pgm\n") + kRules);
  expect_verified("ros.yaml",
                  {"--robot", "unicycle", "--start", "2,1,1.5", "--goal", "2,6,0.5", "--unknown", "occupied"});
  write("bench.yaml",
        "environment:\n  min: [0, 0]\n  max: [12, 8]\n"
        "robots:\n  - {type: unicycle1_v0, start: [2, 4, 0], goal: [9, 4, 0]}\n  - {start: [2, 2, 0]}\n");
  const Outcome outcome = krait({"plan", "bench.yaml", "--robot", "unicycle"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("solved: unicycle (1 body) in bench"));
  EXPECT_THAT(outcome.errors, testing::StartsWith("krait-compile: warning: bench.yaml: robots: only the first one's"));
  EXPECT_THAT(outcome.output, HasSubstr("goal 'goal': within 0.1 m of 9,4, heading 0 rad, within 0.1 rad"));
}

TEST_F(CliMap, UnknownCellsCountAsAsked) {
  write("image.pgm", divided_image());
  write("ros.yaml", std::string("image: image.pgm\n") + kRules);
  const auto ends = [&](const Arguments& more) {
    Arguments arguments = across(more);
    arguments.insert(arguments.begin(), {"plan", "ros.yaml"});
    const Outcome outcome = krait(arguments);
    return std::to_string(outcome.code) + " " + outcome.output.substr(0, outcome.output.find(':'));
  };
  EXPECT_EQ(ends({}), "1 no_route");
  EXPECT_EQ(ends({"--unknown", "occupied"}), "1 no_route");
  EXPECT_EQ(ends({"--unknown", "free"}), "0 solved");
}

// A wall of 16 steps, which a tolerance makes smooth.
TEST_F(CliMap, TheToleranceReachesTheCompiler) {
  ordered_json stairs = {{"bounds", {{"min", {0, 0}}, {"max", {12, 8}}}}};
  for (int i = 0; i < 16; ++i) {
    stairs["obstacles"].push_back({{"box", {{"center", {6, 0.25 + 0.2 * i}}, {"size", {1 + 0.2 * (i % 2), 0.5}}}}});
  }
  write("stairs.json", stairs.dump());
  const auto pieces = [&](const Arguments& more) {
    Arguments arguments = {"compile", "stairs.json", "-o", "stairs.krait"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_done(arguments);
    return planned("stairs.krait", kAcross);
  };
  const ordered_json exact = pieces({});
  const ordered_json coarse = pieces({"--tolerance", "1"});
  EXPECT_NE(exact, coarse);
  EXPECT_EQ(planned("stairs.json", kAcross), exact);
  EXPECT_EQ(planned("stairs.json", across({"--tolerance", "1"})), coarse);
  EXPECT_EQ(planned("stairs.json", across({"--tolerance", "0"})), exact);
}

TEST_F(CliMap, TheDefaultToleranceNarrowsNoCorridorOfOneCell) {
  write("ros.yaml", kHalfMetreCells);
  for (const bool descends : {true, false}) {
    write("image.pgm", staircase(descends));
    const Arguments query = {"--robot", "turtlebot4",
                             "--start", descends ? "1.25,10.75,0" : "10.75,10.75,0",
                             "--goal",  descends ? "9.75,2.25,0.1" : "2.25,2.25,0.1"};
    expect_verified("ros.yaml", query);
    Arguments arguments = {"plan", "ros.yaml"};
    arguments.insert(arguments.end(), query.begin(), query.end());
    EXPECT_THAT(krait(arguments).output, Not(HasSubstr("--tolerance")));
    arguments.insert(arguments.end(), {"--tolerance", "0.5"});
    expect_refused(arguments, "--tolerance 0 leaves them as they are");
  }
}

TEST_F(CliMap, AStartInANotchThatTheDefaultToleranceFillsIsPlannedFromWithoutIt) {
  write("ros.yaml", kHalfMetreCells);
  write("image.pgm", slope());
  const Arguments arguments = {"plan",    "ros.yaml",       "--robot", "turtlebot4",
                               "--start", "5.25,6.75,0.78", "--goal",  "9.75,9.75,0.1"};
  EXPECT_THAT(krait(arguments).output,
              HasSubstr("the map's cells as they are (--tolerance 0): with obstacles grown by up to 0.25 m"));
}

TEST_F(CliMap, AStartInAMapThatIsMostlyOccupiedIsAskedForItsNegate) {
  write("ros.yaml", kHalfMetreCells);
  const auto said = [&] {
    return krait({"plan", "ros.yaml", "--robot", "turtlebot4", "--start", "3.25,6.75,0", "--goal", "9.75,9.75,0.1"})
        .errors;
  };
  const std::string negate = " % of the map's cells are obstacles: are bright and dark exchanged";
  write("image.pgm", slope());
  EXPECT_THAT(said(), testing::AllOf(HasSubstr("start_in_collision"), Not(HasSubstr(negate))));
  write("image.pgm", staircase(true));
  EXPECT_THAT(said(), testing::AllOf(HasSubstr("start_in_collision"), HasSubstr("; 93.8" + negate)));
}

TEST_F(CliMap, ACompiledSceneLeavesItsRobotTheRoomThatTheMapHas) {
  write("ros.yaml", kHalfMetreCells);
  write("image.pgm", slope());
  const Arguments compiled = {"compile", "ros.yaml", "-o", "slope.krait"};
  const char* const kNotch = "5.25,6.75,0.78";
  const auto said = [&](const Arguments& more) {
    Arguments arguments = compiled;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = krait(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return outcome.errors;
  };
  const std::string exact = "krait-compile: obstacles as they are (--tolerance 0): grown by up to 0.25 m a side";
  const Arguments far = {"--for", "turtlebot4", "--start", "9.75,9.75,0", "--goal"};
  const auto to_goal = [&](const char* goal) {
    Arguments arguments = far;
    arguments.emplace_back(goal);
    return said(arguments);
  };
  EXPECT_THAT(to_goal("1.25,10.75,0.05"), HasSubstr(exact));
  EXPECT_EQ(krait({"plan", "slope.krait", "--robot", "turtlebot4"}).code, 0);
  EXPECT_THAT(to_goal("9.75,8.75,0.1"), Not(HasSubstr(exact)));
  for (const Arguments& robot : {Arguments{}, Arguments{"--for", "turtlebot4"}}) {
    Arguments arguments = robot;
    arguments.insert(arguments.end(), {"--start", kNotch, "--goal", "9.75,9.75,0.1"});
    EXPECT_EQ(said(arguments), "") << "no obstacle grows around a start";
    EXPECT_EQ(krait({"plan", "slope.krait", "--robot", "turtlebot4"}).code, 0);
  }
  EXPECT_THAT(said({"--goal", "5.25,6.75,0.05"}), HasSubstr("krait-compile: warning: goal 'goal' is 0."));
  EXPECT_EQ(said({"--goal", "5.25,6.75,0.05", "--tolerance", "0"}), "");
  EXPECT_EQ(said({"--goal", "9.75,9.75,0.05"}), "");
}

TEST_F(CliMap, OptionsForMapsAreRefusedWithACompiledScene) {
  for (const Arguments& option : {Arguments{"--unknown", "free"},
                                  {"--unknown", "map"},
                                  {"--unit", "0.1"},
                                  {"--datum", "11,48"},
                                  {"--tolerance", "0.1"}}) {
    Arguments arguments = {"plan", "room.krait", "-o", "plan.json"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    expect_refused(arguments, "krait: " + option[0] +
                                  " is for maps, but room.krait is compiled already: use it with krait compile, or "
                                  "plan in the map itself\n");
  }
  expect_refused({"plan", "room.json", "--unknown", "maybe"}, "--unknown: give map, free or occupied, not maybe");
  expect_refused({"plan", "room.json", "--tolerance", "-1"}, "--tolerance: give metres from 0 to 4000, not -1");
  expect_refused({"plan", "room.json", "--tolerance", "nan"}, "--tolerance: give metres from 0 to 4000, not nan");
}

TEST_F(CliMap, ACompiledSceneUnderAnotherNameIsSaid) {
  std::filesystem::copy_file(path("room.krait"), path("room2.json"));
  const std::string warning =
      "krait: warning: room2.json: is read as compiled scene (.krait), which it is, whatever its name says\n";
  const Outcome planned = krait({"plan", "room2.json", "--robot", "car", "-o", "plan.json"});
  EXPECT_EQ(planned.code, 0);
  EXPECT_EQ(planned.errors, warning);
  EXPECT_EQ(krait({"verify", "room2.json", "plan.json", "--robot", "car"}).errors, warning);
}

TEST_F(CliMap, APictureOfKraitsOwnIsNone) {
  expect_done({"plan", "room.krait", "--robot", "car", "--improve", "0", "--svg", "plan.svg"});
  expect_done({"robot", "car", "--svg", "car.svg"});
  for (const std::string picture : {"plan.svg", "car.svg"}) {
    expect_refused({"plan", picture}, picture + ": is a picture that krait has drawn, not a map: give the map itself");
  }
}

// It is exported where its file has it.
TEST_F(CliMap, AFarOneIsSaidToBeMovedWhereItIs) {
  write("far.json", R"({"bounds": {"min": [12000000, 0], "max": [12000020, 10]},
      "goals": [{"name": "east", "box": {"center": [12000017, 5], "size": [2, 2], "angle": 0}}],
      "starts": [{"name": "west", "position": [12000003, 5], "heading": 0}]})");
  expect_done({"export", "far.json", "--json", "same.json"});
  EXPECT_EQ(json("same.json").at("bounds"), json("far.json").at("bounds"));
  const std::string moved = "far.json: lies far from 0: x less 12000010 m and y less 5 m are the coordinates from here";
  EXPECT_THAT(krait({"compile", "far.json", "-o", "far.krait"}).errors, HasSubstr(moved));
  EXPECT_THAT(krait({"plan", "far.json", "--robot", "car"}).errors, HasSubstr(moved));
  const std::string hint = "; a map beyond 1e7 m is moved to around 0: krait compile MAP says by how much\n";
  expect_refused({"plan", "far.json", "--start", "12000003,5,0"}, hint);
  expect_refused({"plan", "far.json", "--goal", "12000003,5,1"}, hint);
  expect_refused({"compile", "far.json", "--start", "12000003,5,0", "-o", "x.krait", "--quiet"}, hint);
  EXPECT_THAT(krait({"plan", "far.json", "--start", "3,5,7"}).errors, Not(HasSubstr("is moved")));
}

TEST_F(CliMap, WhatIsNeitherIsToldTheFormats) {
  write("letter", "Dear robot,\n");
  expect_refused({"plan", "letter", "-o", "plan.json"},
                 "krait: letter: is in no known format; known are compiled scene (.krait), SVG, GeoJSON, "
                 "krait's JSON, TPCAP case (.csv), MovingAI .map, map_server YAML, dynobench YAML\n");
}

TEST_F(CliMap, WhatTheCompilerRefusesIsSaidOnceAndEndsIt) {
  write("far.json", R"({"bounds": {"min": [0, 0], "max": [5000, 5]}})");
  expect_refused({"plan", "far.json", "--robot", "car", "--start", "1,1,0", "--goal", "4,4,0.5", "-o", "plan.json"},
                 "krait-compile: the bounds");
  write("two.json", R"({"bounds": {"min": [0, 0], "max": [9, 9]}, "goals": [
      {"name": "a", "box": {"center": [5, 5], "size": [2, 2]}},
      {"name": "b", "box": {"center": [5, 5], "size": [1, 1]}}]})");
  expect_refused({"plan", "two.json", "-o", "plan.json"},
                 "krait-compile: the goals 'a' and 'b' overlap: move or shrink one\n");
}

TEST_F(CliMap, AMissingCompilerIsSaid) {
  std::filesystem::create_directory(path("bin"));
  std::filesystem::copy_file(test::program_path("krait"), path("bin/krait"));
  const Outcome outcome = run_program(path("bin/krait"), {"plan", "room.json", "--robot", "car"}, directory());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.errors, "krait: cannot run " + std::filesystem::canonical(path("bin")).string() +
                                "/krait-compile: it must lie beside krait (build the target krait-compile)\n");
}

// In place of krait-compile: a script of the test's own, beside a copy of krait.
class CliCompilerEnds : public CliMap {
 protected:
  void replace_compiler(const std::string& script) const {
    std::filesystem::create_directories(path("bin"));
    std::filesystem::copy_file(test::program_path("krait"), path("bin/krait"),
                               std::filesystem::copy_options::overwrite_existing);
    write("bin/krait-compile", "#!/bin/bash\n" + script + "\n");
    std::filesystem::permissions(path("bin/krait-compile"), std::filesystem::perms::owner_all);
  }

  Outcome krait_with_compiler(const std::string& script) const {
    replace_compiler(script);
    return run_program(path("bin/krait"), {"plan", "room.json", "--robot", "car", "-o", "plan.json"}, directory());
  }

  // Starts krait plan on a map with standard error on `errors`.
  pid_t start_krait(int errors) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    const std::string program = path("bin/krait");
    ::dup2(errors, STDERR_FILENO);
    ::close(errors);
    if (::chdir(directory().c_str()) == 0) ::execl(program.c_str(), "krait", "plan", "room.json", nullptr);
    ::_exit(127);
  }
};

TEST_F(CliCompilerEnds, WithEveryExitCodeAndSignal) {
  EXPECT_EQ(krait_with_compiler("cat room.krait").code, 0);
  for (const int code : {2, 3}) {
    const Outcome outcome = krait_with_compiler("echo why >&2; exit " + std::to_string(code));
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(outcome.errors, "why\n");
  }
  const Outcome killed = krait_with_compiler("kill -KILL $$");
  EXPECT_EQ(killed.code, 2);
  EXPECT_EQ(
      killed.errors,
      "krait: room.json: krait-compile was ended by signal 9 (Killed); has this machine enough memory for the map?\n");
  const Outcome half = krait_with_compiler("head -c 1000 room.krait");
  EXPECT_EQ(half.code, 2);
  EXPECT_THAT(half.errors, testing::StartsWith("krait: room.json: bad_scene: "));
}

// A compiler that leaves a wall out, in place of one: the pieces would not tell.
TEST_F(CliCompilerEnds, WithASceneThatIsNotTheMapAndTheMapTells) {
  ordered_json open = json("room.json");
  open.erase("obstacles");
  write("open.json", open.dump());
  expect_done({"compile", "open.json", "-o", "open.krait"});
  replace_compiler("cat open.krait");
  const Outcome outcome = run_program(
      path("bin/krait"), {"plan", "room.json", "--robot", "car", "--goal", "south", "-o", "plan.json"}, directory());
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.errors, HasSubstr("obstacles[0]"));
  EXPECT_THAT(outcome.errors, HasSubstr("krait: the plan does not hold: a bug of krait, please report it"));
  EXPECT_EQ(json("plan.json").at("status"), "verification_failed");
  EXPECT_EQ(json("plan.json").at("states"), ordered_json::array());
  expect_done({"plan", "open.krait", "--robot", "car", "--goal", "south", "-o", "plan.json"});
}

// Whether all processes that hold the pipe's other end have ended within five seconds.
bool is_closed(int pipe_end) {
  pollfd look = {pipe_end, POLLIN, 0};
  char text[256];
  while (::poll(&look, 1, 5000) == 1) {
    if (::read(pipe_end, text, sizeof text) <= 0) return true;
  }
  return false;
}

// Waits until the process has a child.
bool has_child_soon(pid_t process) {
  const std::string id = std::to_string(process);
  for (int i = 0; i < 1000; ++i) {
    if (!read_text("/proc/" + id + "/task/" + id + "/children").empty()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

// No file is left, and no compiler at work.
TEST_F(CliCompilerEnds, WithKraitWhateverSignalEndsThat) {
  replace_compiler("exec sleep 60");
  const auto before = files();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
    int ends[2];
    ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    const pid_t krait = start_krait(ends[1]);
    ::close(ends[1]);
    EXPECT_TRUE(has_child_soon(krait));
    ::kill(krait, signal);
    int status = 0;
    ::waitpid(krait, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal);
    EXPECT_TRUE(is_closed(ends[0])) << "after signal " << signal;
    ::close(ends[0]);
  }
  EXPECT_EQ(files(), before);
}

// As a program that ignores its children's ends starts it.
TEST_F(CliMap, IsNotConfusedByIgnoredSignals) {
  const auto plan = [&](const char* map) {
    return run_program("/usr/bin/env",
                       {"--ignore-signal=CHLD,PIPE", test::program_path("krait"), "plan", map, "--robot", "car"},
                       directory());
  };
  const Outcome solved = plan("room.json");
  EXPECT_EQ(solved.code, 0) << solved.errors;
  write("bad.json", R"({"bounds": {"min": [0, 0], "max": [9, 9]},
      "starts": [{"name": "s", "position": [1, 1], "heading": 0}],
      "goals": [{"name": "a", "polygon": [[4, 4], [6, 4], [6, 6]]},
                {"name": "b", "polygon": [[4, 4], [6, 4], [6, 7]]}]})");
  const Outcome refused = plan("bad.json");  // by the compiler
  EXPECT_THAT(refused.errors, HasSubstr("overlap"));
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(std::count(refused.errors.begin(), refused.errors.end(), '\n'), 1) << refused.errors;
}

TEST_F(CliMap, MayHaveANameThatBeginsWithAMinus) {
  std::filesystem::copy_file(path("room.json"), path("-room.json"));
  expect_done({"plan", "--robot", "car", "--", "-room.json"});
}

// A page of 400 units, 20 m by a unit of 5 cm.
TEST_F(CliMap, AUnitIsHandedOn) {
  write("m.svg", R"(<svg viewBox="0 0 400 400"><rect x="100" y="100" width="20" height="20"/></svg>)");
  expect_verified("m.svg", {"--robot", "car", "--start", "2,-2,0", "--goal", "18,-18,0.5", "--unit", "0.05"});
}

}  // namespace
}  // namespace krait::host
