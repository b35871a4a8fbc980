// SPDX-License-Identifier: Apache-2.0
// The help teaches: every option of every command, the robots' defaults, what the exit codes mean.
#include "host/cli/program.hpp"
#include "host/import/import.hpp"
#include "host/robot_file/robot_file.hpp"
#include "host/run/run.hpp"
#include "host/workspace/printed.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

using testing::HasSubstr;

class CliHelp : public CliTest {
 protected:
  std::string help(const std::vector<std::string>& command) const {
    std::vector<std::string> arguments = command;
    arguments.emplace_back("--help");
    const Outcome outcome = krait(arguments);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.errors, "");
    return outcome.output;
  }

  static void expect_all(const std::string& text, std::initializer_list<const char*> words) {
    for (const char* word : words) EXPECT_THAT(text, HasSubstr(word));
  }
};

TEST_F(CliHelp, NamesEveryCommandAndExitCode) {
  expect_all(help({}), {"compile", "info", "plan", "verify", "scene", "robot ", "robots", "0 done", "1 an honest no",
                        "2 bad input", "3"});
}

TEST_F(CliHelp, ShowsAFirstPlanThatWorks) {
  const std::string text = help({});
  expect_all(text, {"krait scene openings -o openings.json", "krait compile openings.json -o openings.krait",
                    "krait plan openings.krait --robot snake:15 -o plan.json --html plan.html",
                    "krait verify openings.json plan.json --robot snake:15"});
  expect_done({"scene", "openings", "-o", "openings.json"});
  expect_done({"compile", "openings.json", "-o", "openings.krait"});
  expect_done({"plan", "openings.krait", "--robot", "snake:15", "-o", "plan.json", "--html", "plan.html"});
  expect_done({"verify", "openings.json", "plan.json", "--robot", "snake:15"});
}

TEST_F(CliHelp, TeachesCompile) {
  expect_all(help({"compile"}), {"INPUT", "-o", "--start", "X,Y,HEADING", "--goal", "X,Y,RADIUS", "--unknown", "free",
                                 "occupied", "map", "--tolerance", "--unit", "--datum"});
}

TEST_F(CliHelp, NamesEveryFormatWhereAMapIsRead) {
  const std::string formats = map_formats();
  expect_all(formats, {"map_server", "MovingAI", "dynobench", "JSON", "GeoJSON", "SVG", "TPCAP"});
  EXPECT_THAT(help({"compile"}), HasSubstr(formats));
  EXPECT_THAT(help({"plan"}), HasSubstr(formats));
}

TEST_F(CliHelp, TeachesPlan) {
  expect_all(
      help({"plan"}),
      {"SCENE",     "--robot",      "snake:N",      "truck:N",     "car",       "unicycle", "diff_drive", "ROBOT.json",
       "--planner", "adaptive",     "--seed",       "--start",     "--goal",    "NAME",     "X,Y,RADIUS", "--memory",
       "64M",       "--iterations", "--time-limit", "--alpha",     "--beta",    "--gamma",  "--kappa",    "--clearance",
       "--paper",   "-o",           "--csv",        "--svg",       "--unit",    "--datum",  "--unknown",  "--tolerance",
       "--png",     "--html",       "no_route",     "budget_used", "tree_full", "time_used"});
}

TEST_F(CliHelp, SaysWhatIsImprovedUnasked) {
  EXPECT_THAT(help({"plan"}),
              HasSubstr("(default: 10, or more where those make fewer than 300000 checks; 0, the first plan, with "));
}

TEST_F(CliHelp, SaysWhatHoldsUnasked) {
  expect_all(help({"plan"}),
             {"in metres and radians (default: its first)", "(default: that of the map's goal, else any)",
              "(default: 0, at rest;\n                              inf with --paper;"});
  expect_all(help({"verify"}),
             {"in metres and radians (default: where the plan begins)",
              "(default: the plan's own, or any where it has none)", "prior and rrt do not brake, and need inf)"});
}

TEST_F(CliHelp, ListsTheDefaultsOfEveryRobot) {
  const std::string text = help({"plan"});
  for (const std::string& model : robot_models()) {
    EXPECT_THAT(text, HasSubstr(model + ": body_length")) << model;
  }
  expect_all(text,
             {"body_width 0.5", "wheelbase 0.8", "hitch_length 0.8", "max_speed 2.5", "max_steering 1",
              "max_acceleration 5", "max_steering_rate 4", "self_collision_gap", "max_hitch_angle", "max_turn_rate 2",
              "wheel_radius 0.08", "track_width 0.36", "max_wheel_speed 12", "max_wheel_acceleration 24"});
}

TEST_F(CliHelp, TeachesInfoVerifyAndScene) {
  expect_all(help({"info"}), {"SCENE", ".krait", "--robot", "--memory", "--dt"});
  expect_all(help({"verify"}), {"INPUT", "PLAN", "--robot", "--start", "--goal", "--unknown"});
  expect_all(help({"robot"}), {"ROBOT", "--svg", "--png", "ROBOT.json"});
  expect_all(help({"robots"}), {"shipped robots"});
  expect_all(help({"scene"}), {"openings", "gates", "rooms", "comb", "corridors", "streets", "--scale", "-o"});
}

TEST_F(CliHelp, SaysItsVersion) {
  const Outcome outcome = krait({"--version"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.output, testing::ContainsRegex("^krait [0-9]+\\.[0-9]+\\.[0-9]+\n$"));
}

// Metres.
double narrowest_portal(const std::string& file) {
  const SceneBytes bytes = SceneBytes::read(file);
  const krait::Scene scene = open_scene(file, bytes);
  double width = 1e9;
  for (Index i = 0; i < scene.portal_count(); ++i) width = std::min(width, static_cast<double>(scene.portal_width(i)));
  return width;
}

TEST_F(CliHelp, InfoReportsRegionsPiecesBytesAndTheNarrowestPortal) {
  const Outcome outcome = krait({"info", "room.krait"});
  EXPECT_EQ(outcome.code, 0);
  expect_all(outcome.output, {"room", "triangles", "portals", "narrowest", "convex pieces", "east, south",
                              "west, north", "clearance", "names", "advance(1) of snake:15: at most 1241 placements"});
  expect_all(krait({"info", "room.krait", "--robot", "car"}).output, {"advance(1) of car: at most 1241 placements"});
  EXPECT_THAT(outcome.output, HasSubstr(printed("the narrowest %.3f m wide", narrowest_portal(path("room.krait")))));
  const auto size = std::filesystem::file_size(path("room.krait"));
  EXPECT_THAT(outcome.output, testing::ContainsRegex("total +" + std::to_string(size)));
}

// Of text like "at least 123 bytes", the number behind the words.
std::uint64_t number_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  EXPECT_NE(at, std::string::npos) << words << " is not in " << text;
  return at == std::string::npos ? 0 : std::stoull(text.substr(at + words.size()));
}

TEST_F(CliHelp, InfoReportsTheLeastBlockAndItsPools) {
  const std::string least = krait({"info", "room.krait", "--robot", "car", "--memory", "100"}).output;
  expect_all(least, {"RAM for car: at least ", "100 is too little"});
  const std::uint64_t bytes = number_after(least, "at least ");
  const auto plan = [&](std::uint64_t memory) {
    return krait({"plan", "room.krait", "--robot", "car", "--start", "west", "--goal", "east", "--memory",
                  std::to_string(memory), "--iterations", "1000", "-o", "plan.json"});
  };
  EXPECT_THAT(krait({"info", "room.krait", "--robot", "car", "--memory", std::to_string(bytes)}).output,
              HasSubstr("; " + std::to_string(bytes) + " holds 2 vertices"));
  EXPECT_LE(plan(bytes).code, 1);
  EXPECT_THAT(plan(bytes - 1).errors, testing::HasSubstr("need at least " + std::to_string(bytes) + " bytes"));

  const std::string info = krait({"info", "room.krait", "--robot", "car", "--memory", "40000"}).output;
  const std::string pools = info.substr(info.find("pool of RAM"));
  std::uint64_t sum = 0;
  for (const char* pool : {"regions", "portals", "groups", "vertices", "states", "expansions", "members", "work"}) {
    sum += number_after(pools, std::string("\n") + pool + " ");
  }
  EXPECT_EQ(number_after(pools, "\ntotal "), sum);
  EXPECT_LE(sum, 40'000U);
  const std::uint64_t vertices = number_after(info, "40000 holds ");
  const double each = static_cast<double>(number_after(info, "bytes, and "));
  EXPECT_NEAR(static_cast<double>(bytes) + each * static_cast<double>(vertices), 40'000.0, 200.0);
}

TEST_F(CliHelp, InfoSaysThatTheTimeStepIsTooLongAndNotTheBlockTooSmall) {
  write("fast.json", R"({"model": "car", "parameters": {"max_speed": 50, "max_acceleration": 3, "min_speed": -1}})");
  const std::vector<std::string> info = {"info", "room.krait", "--robot", "fast.json", "--memory", "1G"};
  expect_refused(info, "krait: bad_argument: dt: at most 0.081 s for a robot so fast and so short: try --dt 0.081\n");
  std::vector<std::string> shorter = info;
  shorter.insert(shorter.end(), {"--dt", "0.08"});
  EXPECT_THAT(krait(shorter).output, HasSubstr("1G holds "));
  expect_refused({"info", "room.krait", "--dt", "2"}, "--dt");
}

}  // namespace
}  // namespace krait::host
