// SPDX-License-Identifier: Apache-2.0
// What is shown while krait works for long, and what Ctrl-C leaves.
#include <random>
#include <thread>

#include "host/cli/program.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

using namespace std::chrono_literals;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

std::string krait_path() { return test::program_path("krait"); }

// A MovingAI map of `side` by `side` cells, of which every seventeenth or so is occupied and stands alone.
std::string scattered_cells(int side) {
  const std::string size = std::to_string(side);
  std::string text = "type octile\nheight " + size + "\nwidth " + size + "\nmap\n";
  std::minstd_rand draw(1);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) text += draw() % 17 == 0 ? '@' : '.';
    text += '\n';
  }
  return text;
}

class CliProgress : public CliTest {
 protected:
  // A search that finds nothing, however long: the car cannot turn to the door.
  std::vector<std::string> endless(std::initializer_list<std::string> more = {}) const {
    write("stiff.json", R"({"model": "car", "parameters": {"max_steering": 0.01}})");
    std::vector<std::string> arguments = {"plan",     "room.krait", "--robot",      "stiff.json",
                                          "--start",  "3,8,-0.5",   "--goal",       "east",
                                          "--memory", "1M",         "--iterations", "1000000000000"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  Outcome interrupted(const std::vector<std::string>& arguments) const {
    return run_and_interrupt(krait_path(), arguments, directory(), 1500ms);
  }
  // The same after so many seconds, with standard error on a terminal; a shell's exit code.
  Outcome interrupted_on_terminal(const std::vector<std::string>& arguments, const char* seconds) const {
    std::vector<std::string> timed = {"--preserve-status", "-s", "INT", seconds, krait_path()};
    timed.insert(timed.end(), arguments.begin(), arguments.end());
    return run_on_terminal("/usr/bin/timeout", timed, directory());
  }
  // What a terminal shows of a program that was at this step, and was stopped with this line.
  static testing::Matcher<std::string> stopped_at(const std::string& step, const std::string& line) {
    return testing::AllOf(ContainsRegex("\r\033\\[K" + step), testing::EndsWith("\r\033[K" + line + "\r\n"));
  }
  // A plan of so many steps in which the robot stands still, in stands.json.
  void write_standing(const char* robot, int steps) const {
    expect_done({"plan", "room.krait", "--robot", robot, "--goal", "3,5,0.5", "--improve", "0", "-o", "plan.json"});
    nlohmann::ordered_json plan = json("plan.json");
    const std::string state = plan["states"][0].dump(), control = "[0,0]";
    plan.erase("states");
    plan.erase("controls");
    std::string text = plan.dump();
    text.pop_back();
    text += R"(,"states":[)" + state;
    for (int i = 0; i < steps; ++i) text += "," + state;
    text += R"(],"controls":[)" + control;
    for (int i = 1; i < steps; ++i) text += "," + control;
    write("stands.json", text + "]}");
  }
  // Until the file is there, or five seconds.
  void wait_for(const char* file) const {
    for (int i = 0; i < 100 && !std::filesystem::exists(path(file)); ++i) std::this_thread::sleep_for(50ms);
  }
};

TEST_F(CliProgress, CtrlCEndsASearchAsATimeLimitDoes) {
  const Outcome outcome = interrupted(endless({"-o", "plan.json", "--csv", "plan.csv"}));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output, testing::StartsWith("time_used: car"));
  EXPECT_THAT(outcome.output, ContainsRegex("\nstopped by you after [1-9][0-9]+ iterations\n"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("--time-limit")));
  EXPECT_THAT(outcome.output, Not(HasSubstr("has every bend so much room?")));
  EXPECT_EQ(json("plan.json").at("status"), "time_used");
  EXPECT_EQ(json("plan.json").at("states").size(), 0U);
}

TEST_F(CliProgress, CtrlCLeavesTheBestPlanSoFar) {
  const Outcome outcome =
      interrupted({"plan", "room.krait", "--robot", "car", "--improve", "1000000", "-o", "plan.json"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_THAT(outcome.output,
              ContainsRegex("\nstopped by you after [1-9][0-9]* iterations: this is the best plan so far\n"));
  EXPECT_THAT(outcome.output, HasSubstr(", verified\n"));
  expect_done({"verify", "room.json", "plan.json", "--robot", "car"});
}

TEST_F(CliProgress, CtrlCLeavesTheFirstPlanWhereItIsTheBest) {
  const Outcome outcome =
      interrupted({"plan", "room.krait", "--robot", "car", "--goal", "5,5,0.5", "--improve", "1000000"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("\nno better plan was found before you stopped it\n"));
}

TEST_F(CliProgress, NothingIsLeftBesideTheOutputs) {
  const auto before = files();
  interrupted(endless());
  auto after = files();
  after.erase(path("stiff.json"));
  EXPECT_EQ(after, before);
}

// As nohup and shells without job control start what runs in the background.
TEST_F(CliProgress, WhereCtrlCIsIgnoredItStaysSo) {
  std::string command = "trap '' INT; exec " + krait_path();
  for (const std::string& argument : endless({"--time-limit", "2.5"})) command += " " + argument;
  const Outcome outcome = run_and_interrupt("/bin/sh", {"-c", command}, directory(), 1500ms);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, Not(HasSubstr("stopped by you")));
}

TEST_F(CliProgress, CtrlCEndsTheCompilerWithALine) {
  write("large.map", scattered_cells(700));
  const auto before = files();
  const Outcome outcome = interrupted_on_terminal({"compile", "large.map", "-o", "large.krait"}, "1.5");
  EXPECT_EQ(outcome.code, 128 + SIGINT);
  EXPECT_EQ(outcome.output, "");
  EXPECT_THAT(outcome.errors,
              stopped_at("krait-compile: [a-z ]+: [0-9]+ s",
                         "krait-compile: stopped by you while the map was compiled: nothing is written"));
  EXPECT_EQ(files(), before);
}

TEST_F(CliProgress, CtrlCEndsAnExportWithALine) {
  write("large.map", scattered_cells(2000));
  const auto before = files();
  const Outcome outcome =
      interrupted_on_terminal({"export", "large.map", "--json", "a.json", "--geojson", "a.geojson"}, "1.5");
  EXPECT_EQ(outcome.code, 128 + SIGINT);
  EXPECT_EQ(outcome.output, "");
  EXPECT_THAT(outcome.errors, stopped_at("krait: (reading the map|making JSON|making GeoJSON): [0-9]+ s",
                                         "krait: stopped by you while the map was converted: nothing is written"));
  EXPECT_EQ(files(), before);
}

TEST_F(CliProgress, CtrlCEndsAVerificationWithALine) {
  write_standing("snake:10", 60'000);
  const Outcome outcome = interrupted_on_terminal(
      {"verify", "room.json", "stands.json", "--robot", "snake:10", "--goal", "3,5,0.5"}, "1.5");
  EXPECT_EQ(outcome.code, 128 + SIGINT);
  EXPECT_EQ(outcome.output, "");
  EXPECT_THAT(outcome.errors, stopped_at("krait: verifying: [0-9]+ s, [1-9][0-9]* of 60000 steps",
                                         "krait: stopped by you: the plan is not judged"));
}

// To draw, the search is repeated, which takes longer with an eye on it.
TEST_F(CliProgress, CtrlCWhilePicturesAreDrawnHasALine) {
  const Outcome outcome =
      interrupted_on_terminal(endless({"--time-limit", "1", "--png", "no.png", "-o", "plan.json"}), "1.5");
  EXPECT_EQ(outcome.code, 128 + SIGINT);
  EXPECT_THAT(outcome.output, testing::StartsWith("time_used: "));
  EXPECT_THAT(outcome.errors, stopped_at("krait: drawing: [0-9]+ s",
                                         "krait: stopped by you while pictures were drawn: none is written"));
  EXPECT_EQ(json("plan.json").at("status"), "time_used");
  EXPECT_FALSE(std::filesystem::exists(path("no.png")));
}

// The reader begins long after the program was interrupted, and a pipe has no room for all of the scene.
TEST_F(CliProgress, CtrlCWhileTheSceneIsWrittenComesTooLate) {
  write("small.map", scattered_cells(100));
  const std::string reader = "sleep 3; cat >late; mv late scene.krait";
  const std::string command = "exec " + krait_path() + " compile small.map -o /dev/stdout > >(" + reader + ")";
  const Outcome outcome = run_and_interrupt("/bin/bash", {"-c", command}, directory(), 1500ms);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.errors, "");
  wait_for("scene.krait");
  EXPECT_THAT(krait({"info", "scene.krait"}).output, HasSubstr("small"));
}

// The pipe that the plan goes to has no room for all of it, and its reader begins after the interrupt.
TEST_F(CliProgress, CtrlCWhileThePlanIsWrittenComesTooLate) {
  const std::string plan = " plan room.krait --robot snake:15 --dt 0.01 --improve 0 -o /dev/stdout --csv plan.csv";
  const std::string command = "exec " + krait_path() + plan + " > >(sleep 3; cat >late; mv late shown)";
  const Outcome outcome = run_and_interrupt("/bin/bash", {"-c", command}, directory(), 1500ms);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.errors, "");
  wait_for("shown");
  const std::string shown = read_text(path("shown"));
  EXPECT_GT(shown.size(), 1U << 16U);
  EXPECT_THAT(shown, HasSubstr(", verified\n"));
  EXPECT_TRUE(std::filesystem::exists(path("plan.csv")));
}

// A terminal sends it to both programs, of which the one that plans has the word.
TEST_F(CliProgress, CtrlCWhileTheMapIsCompiledHasALine) {
  std::filesystem::copy_file(krait_path(), path("krait"));
  write("krait-compile", "#!/bin/sh\nkill -INT $$\nprintf '\\rreading the map: 1 s' >&2\nkill -INT $PPID\n");
  std::filesystem::permissions(path("krait-compile"), std::filesystem::perms::owner_all);
  const std::string line = "krait: stopped by you while the map was compiled: nothing is written";
  const Outcome outcome = run_program(path("krait"), {"plan", "room.json", "--robot", "car"}, directory());
  EXPECT_EQ(outcome.code, -SIGINT);
  EXPECT_EQ(outcome.errors, "\rreading the map: 1 s" + line + "\n");
  const Outcome shown = run_on_terminal(path("krait"), {"plan", "room.json", "--robot", "car"}, directory());
  EXPECT_EQ(shown.code, -SIGINT);
  EXPECT_THAT(shown.errors, HasSubstr("\r\033[K" + line));
}

TEST_F(CliProgress, ATimeLimitAsksForALongerOneAndForWhatElseMayHelp) {
  const Outcome outcome = run_program(krait_path(), endless({"--time-limit", "0.5"}), directory());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("\n  try a longer --time-limit\n"));
  EXPECT_THAT(outcome.output, HasSubstr("has every bend so much room?"));
}

TEST_F(CliProgress, ATerminalShowsHowFarItIsAndIsLeftClean) {
  const Outcome outcome = run_on_terminal(krait_path(), endless({"--time-limit", "2.5"}), directory());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.errors, ContainsRegex("krait: planning: [12] s, [0-9]+ iterations, cost still to go [0-9.]+"));
  EXPECT_THAT(outcome.errors, testing::EndsWith("\r\033[K"));
}

TEST_F(CliProgress, ATerminalShowsTheBestPlanSoFar) {
  const Outcome outcome = run_on_terminal(
      krait_path(), {"plan", "room.krait", "--robot", "car", "--improve", "1000000", "--time-limit", "2.5"},
      directory());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.errors,
              ContainsRegex("krait: improving: [0-9]+ s, best plan [0-9.]+ s, [0-9.]+ m, improved [0-9]+ times?"));
}

TEST_F(CliProgress, AQuickCommandShowsNothing) {
  EXPECT_EQ(run_on_terminal(krait_path(), {"plan", "room.json", "--robot", "car"}, directory()).errors, "");
  EXPECT_EQ(run_program(krait_path(), endless({"--time-limit", "2.5"}), directory()).errors, "");
}

TEST_F(CliProgress, WithoutATerminalALongStepHasOneLine) {
  const Outcome outcome = run_program(krait_path(), endless({"--time-limit", "7"}), directory());
  EXPECT_THAT(outcome.errors,
              testing::MatchesRegex("krait: planning lasts, [0-9]+ iterations, cost still to go [0-9.e+]+\n"));
}

}  // namespace
}  // namespace krait::host
