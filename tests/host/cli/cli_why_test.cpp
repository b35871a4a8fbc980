// SPDX-License-Identifier: Apache-2.0
// What krait plan says where there is no plan: ten blocked scenes and ten hopeless queries in one table, and what is
// common to all of them.
#include "host/cli/program.hpp"

namespace krait::host {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

// A wall of 0.2 m across room.json's bounds, from x on, with a door around y.
struct Door {
  double x, y, width;
};

ordered_json box(double x0, double y0, double x1, double y1) {
  return {{"box", {{"center", {(x0 + x1) / 2, (y0 + y1) / 2}}, {"size", {x1 - x0, y1 - y0}}, {"angle", 0}}}};
}

ordered_json walled(const std::vector<Door>& doors) {
  ordered_json scene = {{"name", "walled"},
                        {"bounds", {{"min", {0, 0}}, {"max", {20, 10}}}},
                        {"obstacles", ordered_json::array()},
                        {"goals", {{{"name", "east"}, {"box", {{"center", {17, 5}}, {"size", {2, 2}}, {"angle", 0}}}}}},
                        {"starts", {{{"name", "west"}, {"position", {3, 5}}, {"heading", 0}}}}};
  for (const Door& door : doors) {
    scene["obstacles"].push_back(box(door.x, 0, door.x + 0.2, door.y - door.width / 2));
    scene["obstacles"].push_back(box(door.x, door.y + door.width / 2, door.x + 0.2, 10));
  }
  return scene;
}

struct Blocked {
  std::vector<Door> doors;
  std::vector<std::string> options;
  std::string says;
};

const std::string kNarrow = "every way to the goal is narrower than the robot: ";

const std::vector<Blocked> kBlocked = {
    {{{10, 5, 0}}, {"--robot", "car"}, "no way leads from the start to the goal: obstacles or the bounds close it off"},
    {{{10, 5, 0.5}}, {"--robot", "car"}, kNarrow + "0.5"},
    {{{10, 2, 0.3}}, {"--robot", "car"}, kNarrow + "0.3"},
    {{{10, 8, 0.59}}, {"--robot", "car"}, ", it needs 0.602 m"},
    {{{8, 5, 2}, {12, 5, 0.4}}, {"--robot", "car"}, " at 12"},
    {{{8, 5, 0.4}, {12, 5, 2}}, {"--robot", "car"}, " at 8"},
    {{{8, 5, 0.4}, {12, 5, 0.3}}, {"--robot", "snake:3"}, " at 12"},
    {{{10, 5, 0.45}}, {"--robot", "truck:1"}, ", it needs 0.502 m"},
    {{{10, 5, 0.38}}, {"--robot", "diff_drive"}, ", it needs 0.402 m"},
    {{{10, 5, 0.7}},
     {"--robot", "car", "--clearance", "0.1"},
     ", it needs 0.8 m; without the --clearance on both sides it would need 0.6 m"}};

class CliWhy : public CliTest {};

TEST_F(CliWhy, BlockedScenesNameTheNarrowestPlaceOfTheWidestWay) {
  for (std::size_t i = 0; i < kBlocked.size(); ++i) {
    write("walled.json", walled(kBlocked[i].doors).dump());
    std::vector<std::string> arguments = {"plan", "walled.json"};
    arguments.insert(arguments.end(), kBlocked[i].options.begin(), kBlocked[i].options.end());
    const Outcome outcome = krait(arguments);
    EXPECT_EQ(outcome.code, 1) << i << outcome.errors;
    EXPECT_THAT(outcome.output, testing::StartsWith("no_route: ")) << i;
    EXPECT_THAT(outcome.output, HasSubstr("0 iterations")) << i;
    EXPECT_THAT(outcome.output, HasSubstr("\n  " + (kBlocked[i].says.front() == ' ' || kBlocked[i].says.front() == ','
                                                        ? kNarrow
                                                        : kBlocked[i].says)))
        << i;
    EXPECT_THAT(outcome.output, HasSubstr(kBlocked[i].says)) << i;
  }
}

struct Hopeless {
  std::vector<std::string> options;
  int code;
  std::string says;
};

const std::vector<Hopeless> kHopeless = {
    {{"--start", "10,2,0"}, 2, "start_in_collision: the robot overlaps an obstacle (piece "},
    {{"--start", "-11.9,5,0"}, 2, "the robot reaches to or beyond the bounds of the workspace at -12.1,"},
    {{"--start", "8.35,2,0", "--clearance", "0.3"}, 2, "the start does not keep the clearance: the robot is 0.1"},
    {{"--robot", "snake:3", "--start", "11.3,2,0"}, 2, "trailer 1 (body 1) overlaps an obstacle"},
    {{"--robot", "truck:2", "--start", "-10.4,2,0"}, 2, "trailer 2 (body 2) reaches to or beyond the bounds"},
    {{"--start", "-50,5,0"}, 2, "start_outside: "},
    {{"--goal", "19.9,0.1,0.05"}, 1, "the robot cannot stand in the goal: its roomiest place is 0.25"},
    {{"--robot", "unicycle", "--goal", "19.95,5,0.04"}, 1, ", it needs 0.402 m"},
    {{"--goal", "10,2,0.5"}, 1, "the goal's middle, 10,2, lies in an obstacle"},
    {{"--goal", "17,5,0.001", "--iterations", "500"}, 1, "  most expansions, "},
    {{"--goal", "17,5,0.001", "--iterations", "500", "--planner", "rrt"}, 1, "  try more --iterations\n"},
    {{"--goal", "17,5,0.001", "--robot", "diff_drive", "--memory", "6K", "--iterations", "100"}, 1, "--memory"}};

TEST_F(CliWhy, HopelessQueriesNameWhatIsInTheWayAndWhatToTry) {
  for (std::size_t i = 0; i < kHopeless.size(); ++i) {
    std::vector<std::string> arguments = {"plan", "room.krait", "--robot", "car"};
    const std::vector<std::string>& options = kHopeless[i].options;
    if (std::find(options.begin(), options.end(), "--robot") != options.end()) arguments.resize(2);
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = krait(arguments);
    EXPECT_EQ(outcome.code, kHopeless[i].code) << i << outcome.errors;
    EXPECT_THAT(outcome.code == 2 ? outcome.errors : outcome.output, HasSubstr(kHopeless[i].says)) << i;
  }
}

TEST_F(CliWhy, AStartOrGoalInAnObstacleIsDrawnAndRefused) {
  const auto refused = [&](const std::vector<std::string>& query) {
    std::vector<std::string> arguments = {"plan",  "room.json", "--robot", "car",     "--svg", "no.svg",
                                          "--png", "no.png",    "--html",  "no.html", "-o",    "no.json"};
    arguments.insert(arguments.end(), query.begin(), query.end());
    const Outcome outcome = krait(arguments);
    EXPECT_EQ(outcome.code, 2);
    for (const char* picture : {"no.svg", "no.png", "no.html"}) {
      EXPECT_TRUE(std::filesystem::remove(path(picture))) << picture;
    }
    EXPECT_FALSE(std::filesystem::exists(path("no.json"))) << "there is no plan";
    return outcome.errors;
  };
  const std::string shown = " (shown in no.svg, no.png, no.html)\n";
  EXPECT_THAT(refused({"--start", "9.8,1,0"}),
              testing::AllOf(testing::StartsWith("krait: start_in_collision: "), testing::EndsWith(shown)));
  EXPECT_THAT(refused({"--goal", "10,1,0.2"}),
              testing::AllOf(testing::StartsWith("krait: goal_in_obstacle: "), testing::EndsWith(shown)));
}

TEST_F(CliWhy, ObstaclesHaveTheNamesThatTheMapHasForThem) {
  const auto said = [&](const std::string& map, const std::string& start) {
    return krait({"plan", map, "--robot", "car", "--goal", "17,5,1", "--start", start}).errors;
  };
  EXPECT_THAT(said("room.json", "9.8,1,0"), HasSubstr("the robot overlaps an obstacle (obstacles[0]) at "));
  EXPECT_THAT(said("room.json", "9.8,9,0"), HasSubstr("the robot overlaps an obstacle (obstacles[1]) at "));
  std::string cells = "type octile\nheight 10\nwidth 20\nmap\n";
  for (int row = 0; row < 10; ++row) cells += row == 7 ? "....@...............\n" : "....................\n";
  write("open.map", cells);
  EXPECT_THAT(said("open.map", "4.5,2.5,0"), HasSubstr("an obstacle (map row 2, columns 4 to 4) at "));
}

// By a quarter of a metre, of a car of 0.6 m by 1.2 m.
TEST_F(CliWhy, GrowthIsBlamedOnlyForAnOverlapThatIsNoDeeper) {
  expect_done({"compile", "room.json", "--tolerance", "0.5", "-o", "grown.krait"});
  const auto said = [&](const std::string& start) {
    return krait({"plan", "grown.krait", "--robot", "car", "--start", start}).errors;
  };
  const std::string blame = "obstacles were grown by up to 0.25 m a side, which may be why";
  EXPECT_THAT(said("8.5,2,0"), HasSubstr(blame));
  EXPECT_THAT(said("9.5,2,0"), testing::AllOf(HasSubstr("overlaps an obstacle"), testing::Not(HasSubstr(blame))));
  EXPECT_THAT(said("9.5,2,1.57"), testing::AllOf(HasSubstr("overlaps an obstacle"), testing::Not(HasSubstr(blame))));
}

constexpr const char* kSlot = R"({"bounds": {"min": [0, 0], "max": [12, 10]}, "obstacles": [
    {"box": {"center": [3, 8], "size": [6, 4], "angle": 0}},
    {"box": {"center": [9.5, 8], "size": [5, 4], "angle": 0}}],
    "starts": [{"name": "home", "position": [2, 2], "heading": 0}]})";

// A car of 1.2 m by 0.6 m has room in a slot of 1 m along it, not across.
TEST_F(CliWhy, AGoalWhereTheRobotHasNoRoomAsItIsTurnedIsRefusedBeforeTheSearch) {
  write("slot.json", kSlot);
  const auto said = [&](const std::vector<std::string>& heading) {
    std::vector<std::string> arguments = {"plan",   "slot.json", "--robot",      "car",
                                          "--goal", "6.5,9,0.2", "--iterations", "300"};
    arguments.insert(arguments.end(), heading.begin(), heading.end());
    return krait(arguments).output;
  };
  const auto refused = testing::AllOf(
      testing::StartsWith("no_route: "), HasSubstr(" s, 0 iterations, "),
      HasSubstr("\n  the robot has no room in the goal as it is asked to be turned; in the goal's middle it meets an "
                "obstacle (obstacles["));
  EXPECT_THAT(said({"--heading", "0"}), refused);
  EXPECT_THAT(said({"--heading", "3.1", "--either-way"}), refused);
  EXPECT_THAT(said({"--heading", "0", "--planner", "rrt"}), refused);
  for (const std::vector<std::string>& along : {std::vector<std::string>{"--heading", "1.57"},
                                                {"--heading", "0", "--heading-tolerance", "1.5"},
                                                {"--heading", "2.8", "--heading-tolerance", "1.25"},
                                                {}}) {
    EXPECT_THAT(said(along), testing::Not(HasSubstr("has no room in the goal")));
  }
}

// A slot of 1 m has no room for 0.9985 m across it with the least clearance either, by half a millimetre: too little to
// prove it, and too little to search for it.
TEST_F(CliWhy, AGoalWithoutRoomIsNotSearchedForOnceMoreWhereLessClearanceHardlyHelps) {
  write("slot.json", kSlot);
  const auto said = [&](const char* length) {
    write("long.json",
          R"({"model": "unicycle", "parameters": {"body_width": 0.4, "body_length": )" + std::string(length) + "}}");
    return krait({"plan", "slot.json", "--robot", "long.json", "--goal", "6.5,9,0.2", "--heading", "0", "--iterations",
                  "300"})
        .output;
  };
  EXPECT_THAT(said("0.9985"), testing::StartsWith("no_route: "));
  EXPECT_THAT(said("0.985"), HasSubstr("a search with 0.008 m used up its iterations"));
}

TEST_F(CliWhy, ATrailerThatIsAskedToStandStraightNeedsRoomToo) {
  write("slot.json", kSlot);
  const auto said = [&](const std::vector<std::string>& straight) {
    std::vector<std::string> arguments = {"plan",      "slot.json", "--robot", "truck:1",      "--goal",
                                          "6.5,9,0.2", "--heading", "0",       "--iterations", "300"};
    arguments.insert(arguments.end(), straight.begin(), straight.end());
    return krait(arguments).output;
  };
  EXPECT_THAT(said({"--hitch-tolerance", "0.2"}),
              testing::AllOf(testing::StartsWith("no_route: "), HasSubstr("\n  the robot has no room in the goal "),
                             HasSubstr("in the goal's middle trailer 1 (body 1) meets an obstacle (obstacles[0])")));
  EXPECT_THAT(said({}), testing::Not(HasSubstr("no room in the goal")));
}

// A disc of 0.3 m finds a way in by the open corner; a body of 4 m has no room between the walls.
TEST_F(CliWhy, AGoalWhereTheRobotHasNoRoomInAnyHeadingIsRefusedBeforeTheSearch) {
  ordered_json pit = walled({});
  pit["obstacles"] = {box(15.9, 4, 18.1, 4.2), box(15.9, 4.2, 16.1, 6), box(16.1, 5.8, 17.4, 6),
                      box(17.9, 4.2, 18.1, 5.4)};
  pit["goals"] = {{{"name", "pit"}, {"box", {{"center", {17, 5}}, {"size", {0.4, 0.4}}, {"angle", 0}}}}};
  write("pit.json", pit.dump());
  write("long.json", R"({"model": "unicycle", "parameters": {"body_length": 4, "body_width": 0.3}})");
  const std::string line =
      "\n  the robot has no room in the goal in any heading; in the goal's middle, with heading 0, it meets an "
      "obstacle (obstacles[";
  for (const char* goal : {"pit", "17,5,0.2"}) {
    const Outcome outcome = krait({"plan", "pit.json", "--robot", "long.json", "--goal", goal, "--png", "no.png"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.output, testing::AllOf(testing::StartsWith("no_route: "), HasSubstr(line)));
    EXPECT_TRUE(std::filesystem::remove(path("no.png")));
  }
}

// As far as the scene says, the slot may have been 1.2 m wide.
TEST_F(CliWhy, GrowthIsBlamedOnlyWhereItMayTakeTheRoomInTheGoal) {
  write("slot.json", kSlot);
  expect_done({"compile", "slot.json", "--tolerance", "0.2", "-o", "grown.krait"});
  const auto said = [&](const char* length) {
    write("long.json",
          R"({"model": "unicycle", "parameters": {"body_width": 0.6, "body_length": )" + std::string(length) + "}}");
    return krait({"plan", "grown.krait", "--robot", "long.json", "--goal", "6.5,9,0.2", "--heading", "0"}).output;
  };
  const std::string blame = "obstacles were grown by up to 0.1 m a side, which may be why";
  EXPECT_THAT(said("1.1"), testing::AllOf(HasSubstr("has no room in the goal"), HasSubstr(blame)));
  EXPECT_THAT(said("1.3"), testing::AllOf(HasSubstr("has no room in the goal"), testing::Not(HasSubstr(blame))));
}

// A blind alley, in which a robot that only drives forwards stands with its front to the wall.
TEST_F(CliWhy, AStartThatTheRobotCannotLeaveIsBlamedInPlaceOfTheGoal) {
  write("alley.json", R"({"bounds": {"min": [0, 0], "max": [12, 10]}, "obstacles": [
      {"box": {"center": [3, 4.66], "size": [6, 2], "angle": 0}},
      {"box": {"center": [3, 7.34], "size": [6, 2], "angle": 0}},
      {"box": {"center": [1, 6], "size": [2, 2], "angle": 0}}],
      "starts": [{"name": "home", "position": [2.7, 6], "heading": 3.14159265}]})");
  write("long.json", R"({"model": "unicycle", "parameters": {"body_length": 1.2, "body_width": 0.6, "min_speed": 0}})");
  const auto said = [&](const char* iterations, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"plan",   "alley.json", "--robot",     "long.json",
                                          "--goal", "9,2,0.3",    "--iterations"};
    arguments.emplace_back(iterations);
    arguments.insert(arguments.end(), more.begin(), more.end());
    return krait(arguments).output;
  };
  const std::string line =
      "\n  none of 2000 expansions led away from the start: try another --start\n"
      "  try a ROBOT.json that may reverse, with a min_speed below 0\n";
  EXPECT_THAT(said("2000", {"--heading", "0"}),
              testing::AllOf(HasSubstr(", 1 vertices"), HasSubstr(line), testing::Not(HasSubstr("--iterations")),
                             testing::Not(HasSubstr("--heading-tolerance"))));
  EXPECT_THAT(said("500", {}), HasSubstr("\n  try more --iterations\n"));
  EXPECT_THAT(said("2000", {"--start", "8,5,0"}), testing::Not(HasSubstr("led away")));
}

TEST_F(CliWhy, AGoalThatIsTinyIsSaidToBe) {
  const auto advice = [&](const std::string& goal) {
    return krait({"plan", "room.krait", "--robot", "car", "--iterations", "100", "--goal", goal}).output;
  };
  const std::string tiny = "\n  the goal is tiny, with a radius of 0.001 m: try 0.05 m or more\n";
  EXPECT_THAT(advice("17,5,0.001"), HasSubstr(tiny));
  EXPECT_THAT(advice("17,5,0.001"), HasSubstr("ways from there hardly ever hit so small a goal"));
  const std::string large = krait({"plan", "room.krait", "--robot", "car", "--iterations", "2"}).output;
  EXPECT_THAT(large, testing::AllOf(HasSubstr("budget_used"), testing::Not(HasSubstr("tiny"))));
}

TEST_F(CliWhy, BendsAreBlamedOnlyWhereTheWayHasSome) {
  const auto advice = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"plan", "room.krait", "--robot", "car", "--iterations", "200"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return krait(arguments).output;
  };
  const std::string bend = "has every bend so much room?", straight = "17,5,0.001", aside = "17,9,0.001";
  EXPECT_THAT(advice({"--goal", straight}), testing::Not(HasSubstr(bend)));
  EXPECT_THAT(advice({"--goal", straight, "--heading", "1"}), HasSubstr(bend));
  EXPECT_THAT(advice({"--goal", straight, "--start", "3,5,2"}), HasSubstr(bend));
  EXPECT_THAT(advice({"--goal", aside, "--start", "3,9,0"}), HasSubstr(bend));
  EXPECT_THAT(advice({"--goal", straight, "--start", "3,5,0.3"}), testing::Not(HasSubstr(bend)));
}

// A car that turns with a radius of 16 m has to turn by so much until it looks at the goal.
TEST_F(CliWhy, BendsAreBlamedWhereTheTurnTowardTheGoalIsOne) {
  write("stiff.json", R"({"model": "car", "parameters": {"max_steering": 0.05}})");
  const auto advice = [&](const std::string& goal, const std::string& start) {
    return krait(
               {"plan", "room.krait", "--robot", "stiff.json", "--iterations", "200", "--goal", goal, "--start", start})
        .output;
  };
  const std::string bend = "it turns with a radius of 15.99 m: has every bend so much room?";
  const std::string near = "6,5,0.001", beyond_the_door = "17,5,0.001";
  EXPECT_THAT(advice(near, "3,5,0.05"), testing::Not(HasSubstr(bend)));
  EXPECT_THAT(advice(near, "3,5,0.2"), HasSubstr(bend)) << "it passes the goal";
  EXPECT_THAT(advice(beyond_the_door, "3,5,0.05"), testing::Not(HasSubstr(bend)));
  EXPECT_THAT(advice(beyond_the_door, "3,5,0.35"), HasSubstr(bend)) << "it meets the door's side";
}

TEST_F(CliWhy, NoHeadingIsAdvisedThatWouldBeRefusedOrIsAskedForAlready) {
  const auto advice = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"plan", "room.krait", "--robot",    "truck:1",   "--iterations",
                                          "5",    "--goal",     "17,5,0.001", "--heading", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return krait(arguments).output;
  };
  EXPECT_THAT(advice({}), HasSubstr("\n  try a larger --heading-tolerance, --either-way, or any heading\n"));
  EXPECT_THAT(advice({"--either-way"}), HasSubstr("\n  try a larger --heading-tolerance, or any heading\n"));
  EXPECT_THAT(advice({"--either-way", "--hitch-tolerance", "0.1", "--heading-tolerance", "3.14159"}),
              HasSubstr("\n  try a larger --hitch-tolerance, or any heading\n"));
}

// The second door is wide enough for a disc in the body, which is broader than long, not for the body.
TEST_F(CliWhy, TheBodyThatStopsMostWaysIsNamed) {
  write("walled.json", walled({{8, 5, 2}, {12, 5, 0.55}}).dump());
  write("broad.json", R"({"model": "unicycle", "parameters": {"body_length": 0.3, "body_width": 0.6}})");
  const Outcome outcome = krait({"plan", "walled.json", "--robot", "broad.json", "--iterations", "3000"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, testing::ContainsRegex("most expansions, [0-9]+, grew from around 1[12]\\.[0-9,.]+: "
                                                     "[0-9]+ of [0-9]+ ways from there end with the robot at an "
                                                     "obstacle \\(obstacles\\[[23]\\]\\), as at 1[12]"));
}

// A diff_drive of 0.5 m drives 0.96 m/s at most.
TEST_F(CliWhy, TimeStepsThatAreTooShortForTheRobotAreSaidToBe) {
  const auto advice = [&](const char* dt, const char* iterations) {
    return krait({"plan", "room.krait", "--robot", "diff_drive", "--dt", dt, "--iterations", iterations}).output;
  };
  const std::string line = "\n  try a longer --dt: an expansion of 40 steps moves the robot by ";
  EXPECT_THAT(advice("0.001", "100"), HasSubstr(line + "0.0384 m at most\n"));
  EXPECT_THAT(advice("0.001", "100"), testing::ContainsRegex("grew from around [-0-9.,]+\n")) << "nothing stops it";
  EXPECT_THAT(advice("0.02", "5"), testing::AllOf(HasSubstr("budget_used"), testing::Not(HasSubstr(line))));
}

TEST_F(CliWhy, WaysThatDidNotHoldAreCounted) {
  write("lane.json", R"({"bounds": {"min": [0, 0], "max": [14, 1.2]}, "obstacles": [],
      "goals": [{"name": "west", "box": {"center": [1.1, 0.6], "size": [0.6, 1], "angle": 0}}],
      "starts": [{"name": "east", "position": [7, 0.6], "heading": 0, "angles": [0]}]})");
  write("pusher.json", R"({"model": "truck", "links": 1, "parameters": {"hitch_length": 0.4, "min_speed": -2.5}})");
  const auto said = [&](const char* iterations) {
    return krait({"plan", "lane.json", "--robot", "pusher.json", "--iterations", iterations, "--clearance", "0.001"})
        .output;
  };
  EXPECT_THAT(said("180"), HasSubstr("\n  1 way reached the goal but did not hold as driven: "));
  EXPECT_THAT(said("2000"), testing::ContainsRegex("\n  [1-9][0-9]+ ways reached the goal but did not hold"));
}

TEST_F(CliWhy, GrowthIsNamedWhereTheWidestWayIsTight) {
  write("broad.json", R"({"model": "unicycle", "parameters": {"body_length": 1.5, "body_width": 1.6}})");
  const auto said = [&](const char* tolerance) {
    expect_done({"compile", "room.json", "--tolerance", tolerance, "-o", "grown.krait"});
    return krait({"plan", "grown.krait", "--robot", "broad.json", "--iterations", "3"}).output;
  };
  const std::string tight = "where the robot needs at least 1.502 m";
  EXPECT_THAT(said("0.5"),
              HasSubstr(tight + "; when the map was compiled, obstacles were grown by up to 0.25 m a side"));
  EXPECT_THAT(said("0"), HasSubstr(tight + "\n"));
}

// The heading of a trailer is not the angle of its hitch.
TEST_F(CliWhy, AHitchThatIsBentTooFarAtTheStartIsNamed) {
  const auto refused = [&](const std::string& angles, const std::string& mention) {
    write("bent.json", R"({"bounds": {"min": [0, 0], "max": [20, 10]}, "obstacles": [],
        "starts": [{"name": "a", "position": [9, 5], "heading": 1, "angles": [)" +
                           angles + "]}]}");
    expect_refused({"plan", "bent.json", "--robot", "truck:2", "--goal", "17,5,1"}, mention);
  };
  const std::string allowed = " rad, and 1.5708 rad are allowed (max_hitch_angle)";
  refused("2.6, 2", "start 'a': the heading of trailer 1, 2.6 rad, bends its hitch by 1.6" + allowed + "\n");
  refused("2, 0.25", "start 'a': the heading of trailer 2, 0.25 rad, bends its hitch by 1.75" + allowed + "\n");
  refused("45, 45", allowed + ": were degrees meant? 45 degrees are 0.7854 radians\n");
  refused("1", "start 'a' gives 1 trailer angle, the robot has 2 trailers\n");
}

TEST_F(CliWhy, AHeadingInDegreesIsAskedAbout) {
  expect_refused({"plan", "room.krait", "--robot", "car", "--start", "3,5,90"},
                 "were degrees meant? 90 degrees are 1.5708");
  expect_refused({"compile", "room.json", "-o", "x.krait", "--start", "3,5,-45"}, "-45 degrees are -0.7854");
  expect_done({"plan", "room.krait", "--robot", "car", "--start", "3,5,6.28"});
}

TEST_F(CliWhy, AMapWithoutFreeSpaceIsRefused) {
  ordered_json scene = walled({});
  scene["obstacles"].push_back(box(-1, -1, 21, 11));
  write("full.json", scene.dump());
  expect_refused({"compile", "full.json", "-o", "full.krait"}, "no free space is left");
  expect_refused({"plan", "full.json", "--robot", "car"}, "no free space is left");
}

}  // namespace
}  // namespace krait::host
