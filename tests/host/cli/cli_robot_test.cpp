// SPDX-License-Identifier: Apache-2.0
// krait robot and krait robots: what they print, draw, warn of and refuse.
#include "host/cli/program.hpp"
#include "host/robot_file/shipped.hpp"
#include "host/run/robot_facts.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class CliRobot : public CliTest {
 protected:
  std::string report(const std::string& robot) const {
    const Outcome outcome = krait({"robot", robot});
    EXPECT_EQ(outcome.code, 0) << robot << ": " << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    return outcome.output;
  }
};

TEST_F(CliRobot, TheShippedOnesAreListedALineEach) {
  const Outcome outcome = krait({"robots"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(static_cast<std::size_t>(std::count(outcome.output.begin(), outcome.output.end(), '\n')),
            shipped_robots().size());
  for (const ShippedRobot& shipped : shipped_robots()) EXPECT_THAT(outcome.output, HasSubstr(shipped.name));
  EXPECT_THAT(outcome.output, HasSubstr("semitrailer         truck:1     tractor with a semitrailer"));
}

TEST_F(CliRobot, OneIsReportedWithUnitsAndSources) {
  const std::string text = report("turtlebot4");
  EXPECT_THAT(text, StartsWith("robot     turtlebot4\n"));
  EXPECT_THAT(text, HasSubstr("model     diff_drive\n"));
  EXPECT_THAT(text, testing::ContainsRegex("track_width +0\\.233 metres +published: iRobot"));
  EXPECT_THAT(text, HasSubstr("turning   turns on the spot, within 0.1851 m"));
  EXPECT_THAT(text, HasSubstr("stops     from 0.31 m/s within 0.05339 m and 0.3444 s"));
  EXPECT_THAT(text, HasSubstr("time step 0.1 s; Runge-Kutta steps in it: 1 in the tree, 4 in a plan"));
  const double error = facts_of("turtlebot4", parse_robot("turtlebot4"), Parameters()).step_error;  // metres
  EXPECT_THAT(text,
              HasSubstr(printed("\naccuracy  %.2g mm off after a second at top speed and full lock\n", 1000 * error)));
}

TEST_F(CliRobot, BodiesThatAreAlikeShareALine) {
  EXPECT_THAT(report("truck:2"),
              HasSubstr("\n  bodies 0 to 2          x -0.35 to 0.35 m, y -0.25 to 0.25 m, 4 corners\n"));
  EXPECT_THAT(report("car"), HasSubstr("\n  body 0                 x "));
  const char* box = R"({"polygon": [[-0.2, -0.1], [0.3, -0.1], [0.3, 0.1], [-0.2, 0.1]]})";
  const char* other = R"({"polygon": [[-0.4, -0.1], [0.3, -0.1], [0.3, 0.1]]})";
  write("mixed.json", printed(R"({"model": "truck", "links": 3, "bodies": [%s, %s, %s, %s]})", other, box, box, other));
  const std::string mixed = report("mixed.json");
  EXPECT_THAT(mixed, HasSubstr("\n  body 0                 x -0.4 to 0.3 m, y -0.1 to 0.1 m, 3 corners\n"
                               "  bodies 1 to 2          x -0.2 to 0.3 m, y -0.1 to 0.1 m, 4 corners\n"
                               "  body 3                 x -0.4 to 0.3 m"));
}

// Of trailers on a circle the last bends most: each rolls on a smaller one than the body before it.
TEST_F(CliRobot, TheLargestHitchAngleIsTold) {
  EXPECT_THAT(report("truck:2"), HasSubstr(", of radius 1.245 m (from 0.2685 to 1.535 m around its centre); hitch "
                                           "angles up to 57 degrees\n"));
}

TEST_F(CliRobot, OnlyItsOwnParametersAreReported) {
  const std::string car = report("car");
  for (const char* other : {"hitch", "self_collision_gap", "wheel_radius", "fold"})
    EXPECT_THAT(car, Not(HasSubstr(other)));
  EXPECT_THAT(car, HasSubstr("wheelbase"));
  EXPECT_THAT(report("truck:2"), HasSubstr("hitch_length"));
  EXPECT_THAT(report("truck:0"), Not(HasSubstr("hitch_length")));
  EXPECT_THAT(report("nissan_leaf"), Not(HasSubstr("body_length")));  // it has a polygon
  EXPECT_THAT(report("unicycle"), Not(HasSubstr("steering")));
}

TEST_F(CliRobot, TrailersThatFoldAreNamed) {
  EXPECT_THAT(report("truck:2"), HasSubstr("but the trailers fold there\nsweeps    1.266 m wide"));
  EXPECT_THAT(report("semitrailer"), Not(HasSubstr("fold")));
}

TEST_F(CliRobot, ASteeredAxleAheadOfItsBodyIsWarnedOf) {
  write("long.json", R"({"model": "truck", "links": 1, "parameters": {"body_length": 1.2, "wheelbase": 0.9}})");
  EXPECT_THAT(report("long.json"),
              HasSubstr("warning   the steered axle lies 0.3 m outside of body 0: a truck's box is "
                        "centred on its rear axle; bodies in a ROBOT.json place it\n"));
  EXPECT_THAT(report("car"), Not(HasSubstr("warning")));
  write("reverse.json", R"({"model": "truck", "links": 1, "parameters": {"min_speed": -1}})");
  EXPECT_THAT(report("reverse.json"), HasSubstr("warning   in reverse no turn is steady"));
  EXPECT_THAT(report("truck:1"), Not(HasSubstr("reverse")));
}

TEST_F(CliRobot, OneThatNeverStandsStillIsReportedAndPlannedFor) {
  write("plane.json", R"({"model": "unicycle", "parameters": {"min_speed": 0.25}})");
  const std::string text = report("plane.json");
  EXPECT_THAT(text, HasSubstr("turning   radius 0.125 m at its least speed"));
  EXPECT_THAT(text, HasSubstr("stops     never: it is no slower than 0.25 m/s\n"));
  const Outcome outcome = krait({"plan", "room.krait", "--robot", "plane.json"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr(", never at rest"));
}

TEST_F(CliRobot, APlanForASteeredAxleAheadOfItsBodyIsWarnedOf) {
  const auto warnings = [&](const std::string& robot) {
    const Outcome outcome = krait({"plan", "room.krait", "--robot", robot});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return outcome.errors;
  };
  const std::string lengths = R"({"model": "truck", "links": 0, "parameters": {"body_length": 1.2, "wheelbase": 0.9})";
  write("long.json", lengths + "}");
  EXPECT_EQ(warnings("long.json"),
            "krait: warning: long.json: the steered axle lies 0.3 m outside of body 0: a truck's box is centred on its "
            "rear axle; bodies in a ROBOT.json place it\n");
  write("placed.json", lengths + R"(, "bodies": [{"polygon": [[-0.1, -0.3], [1, -0.3], [1, 0.3], [-0.1, 0.3]]}]})");
  EXPECT_EQ(warnings("placed.json"), krait({"plan", "room.krait", "--robot", "truck:0"}).errors);
}

TEST_F(CliRobot, ATimeStepThatIsTooLongIsNamed) {
  write("fast.json", R"({"model": "car", "parameters": {"max_speed": 100}})");
  EXPECT_THAT(report("fast.json"), HasSubstr("time step 0.1 s is too long: plan with --dt 0.04 or less\n"));
  write("slower.json", R"({"model": "car", "parameters": {"max_speed": 93}})");
  EXPECT_THAT(report("slower.json"), HasSubstr("plan with --dt 0.044 or less\n"));
}

TEST_F(CliRobot, ItIsDrawnToBothFormats) {
  for (const ShippedRobot& shipped : shipped_robots()) {
    expect_done({"robot", shipped.name, "--svg", "r.svg", "--png", "r.png"});
    EXPECT_THAT(read_text(path("r.svg")), HasSubstr("<title>" + shipped.name)) << shipped.name;
    EXPECT_THAT(read_text(path("r.png")), StartsWith("\x89PNG")) << shipped.name;
  }
}

// Whatever the files are called and the robot says of itself.
TEST_F(CliRobot, ItIsWrittenAsAHeader) {
  write("my car.json", R"({"about": "ends in \\", "model": "car", "parameters": {"wheelbase": 1, "max_speed": 0.3}})");
  expect_done({"robot", "my car.json", "--cpp", "2--x.hpp"});
  const std::string header = read_text(path("2--x.hpp"));
  EXPECT_THAT(header, StartsWith("// The robot my car.json: ends in \\, as krait plan has it.\n"));
  EXPECT_THAT(header, HasSubstr("\nnamespace robot_2_x {\n"));
  EXPECT_THAT(header, HasSubstr("kName[] = \"my_car\";"));
  EXPECT_THAT(header, HasSubstr("    .wheelbase = 1.0F,\n"));
  EXPECT_THAT(header, HasSubstr("    .max_speed = 0.3F,\n"));
}

TEST_F(CliRobot, ExtremeRobotsAreDrawn) {
  write("thin.json", R"({"model": "snake", "links": 25, "parameters": {"body_width": 0.001, "hitch_length": 1000}})");
  write("wide.json", R"({"model": "diff_drive", "parameters": {"track_width": 1000, "body_width": 100}})");
  write("far.json", R"({"model": "truck", "links": 0, "parameters": {"wheelbase": 1000, "max_steering": 0.001}})");
  for (const char* robot : {"thin.json", "wide.json", "far.json", "snake:0", "truck:25"}) {
    expect_done({"robot", robot, "--svg", "r.svg", "--png", "r.png"});
  }
}

TEST_F(CliRobot, WhatCannotBeUsedIsRefused) {
  write("bad.json", R"({"model": "car", "parameters": {"wheelbase": -1}})");
  write("broken.json", R"({"model": )");
  write("side.json", R"({"model": "car", "bodies": [{"polygon": [[0, 0], [500, 0], [500, 1]]}]})");
  expect_refused({"robot"}, "ROBOT is required (see krait robot --help)");
  expect_refused({"robot", "tank"}, "unknown robot \"tank\"; known are snake:N");
  expect_refused({"robot", "snake"}, "say how many trailers it has");
  expect_refused({"robot", "gone.json"}, "gone.json: cannot be read");
  expect_refused({"robot", "bad.json"}, "bad.json: parameters.wheelbase: must be metres from 0.001 to 1000, is -1");
  expect_refused({"robot", "broken.json"}, "broken.json");
  expect_refused({"robot", "side.json"}, "krait: side.json: body 0 reaches 500 m from its axle: bodies must lie");
  expect_refused({"robots", "car"}, "not expected here: car");
}

TEST_F(CliRobot, OneInCentimetresIsAskedAboutByEveryCommand) {
  write("c.json", R"({"model": "car", "parameters": {"body_length": 450, "body_width": 180, "wheelbase": 270}})");
  const std::string why =
      "c.json: body_length 450 m: bodies must lie within 100 m of their axles; were centimetres meant?\n";
  expect_refused({"robot", "c.json"}, "krait: " + why);
  expect_refused({"info", "room.krait", "--robot", "c.json"}, "krait: " + why);
  expect_refused({"plan", "room.json", "--robot", "c.json"}, "krait: " + why);
  expect_refused({"compile", "room.json", "--for", "c.json", "-o", "small.krait"}, "krait-compile: " + why);
}

TEST_F(CliRobot, OutputsAreLookedAtFirst) {
  write("r.json", R"({"model": "car"})");
  expect_refused({"robot", "car", "--svg", "a", "--png", "a"}, "--png a: would overwrite the output --svg a");
  expect_refused({"robot", "r.json", "--png", "r.json"}, "--png r.json: would overwrite the input r.json");
  expect_refused({"robot", "car", "--png", "no/folder.png"}, "no/folder.png: cannot be written");
  expect_refused({"robot", "car", "--svg", "/dev"}, "/dev: cannot be written");
}

TEST_F(CliRobot, AShippedNameIsARobotWhereverOneIsTaken) {
  write("turtlebot4", "a file that has the name of a shipped robot");
  expect_done({"plan", "room.krait", "--robot", "turtlebot4", "-o", "plan.json"});
  expect_done({"verify", "room.json", "plan.json", "--robot", "turtlebot4"});
  expect_done({"info", "room.krait", "--robot", "turtlebot4"});
  EXPECT_EQ(json("plan.json").at("robot").count("sources"), 0U);
  expect_refused({"plan", "room.krait", "--robot", "turtlebot5"}, "the shipped turtlebot3_burger, turtlebot4, ");
}

}  // namespace
}  // namespace krait::host
