// SPDX-License-Identifier: Apache-2.0
// Bad input: exit code 2, one clear line, nothing written.
#include "host/cli/program.hpp"
#include "host/workspace/printed.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using Arguments = std::vector<std::string>;

class CliBadInput : public CliTest {
 protected:
  void expect_plan_refused(Arguments options, const std::string& mention) const {
    Arguments arguments = {"plan", "room.krait", "-o", "plan.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_refused(arguments, mention);
  }

  void expect_input_refused(const std::string& content, const std::string& mention) const {
    write("bad.json", content);
    expect_refused({"compile", "bad.json", "-o", "bad.krait"}, mention);
  }

  void expect_robot_refused(const std::string& content, const std::string& mention) const {
    write("robot.json", content);
    expect_plan_refused({"--robot", "robot.json"}, mention);
  }
};

TEST_F(CliBadInput, WrongUse) {
  expect_refused({}, "command");
  expect_refused({"bogus"}, "bogus");
  expect_refused({"--bogus"}, "--bogus");
  expect_refused({"plan", "--bogus"}, "--bogus");
  expect_refused({"plan", "room.krait", "--bogus"}, "--bogus");
  expect_refused({"plan", "room.krait", "stray"}, "stray");
  expect_refused({"plan"}, "SCENE");
  expect_refused({"info"}, "SCENE");
  expect_refused({"info", "room.krait", "--robot", "bogus"}, "bogus");
  expect_refused({"verify", "room.json"}, "PLAN");
  expect_refused({"compile"}, "INPUT");
  expect_refused({"compile", "room.json"}, "output");
  expect_refused({"compile", "room.json", "-o", "x.krait", "--bogus"}, "--bogus");
  expect_refused({"scene", "nowhere", "-o", "x.json"}, "openings, gates, rooms, comb, corridors, streets");
  expect_refused({"scene", "gates", "-o", "x.json", "--scale", "0"}, "scale");
  expect_refused({"scene", "gates", "-o", "x.json", "--scale", "nan"}, "scale");
  expect_plan_refused({"--planner", "bogus"}, "bogus");
  expect_plan_refused({"--memory"}, "--memory");
}

TEST_F(CliBadInput, MissingFilesAndFolders) {
  std::filesystem::create_directory(path("folder"));
  for (const char* what : {"missing", "folder"}) {
    expect_refused({"compile", what, "-o", "x.krait"}, what);
    expect_refused({"info", what}, what);
    expect_refused({"plan", what}, what);
    expect_refused({"verify", what, "room.json"}, what);
    expect_refused({"verify", "room.json", what}, what);
    expect_plan_refused({"--robot", std::string(what) + ".json"}, what);
  }
}

TEST_F(CliBadInput, MapWithoutItsImage) {
  write("map.yaml",
        "image: gone.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
        "free_thresh: 0.196\n");
  expect_refused({"compile", "map.yaml", "-o", "x.krait"}, "gone.pgm");
}

TEST_F(CliBadInput, NativeScenes) {
  expect_input_refused("", "empty");
  expect_input_refused("{", "JSON");
  expect_input_refused("[]", "object");
  expect_input_refused("{}", "bounds");
  expect_input_refused(R"({"bounds": {"min": [0, NaN], "max": [9, 9]}, "obstacles": []})", "JSON");
  expect_input_refused(R"({"bounds": {"min": [0, -Infinity], "max": [9, 9]}, "obstacles": []})", "JSON");
  expect_input_refused(R"({"bounds": {"min": [0, 0], "max": [9, 1e999]}, "obstacles": []})", "1e999");
  expect_input_refused(R"({"bounds": {"min": [0, 0], "max": [9, 1e300]}, "obstacles": []})", "bounds.max");
  expect_input_refused(R"({"bounds": {"min": [0, 0], "max": [0, 0]}, "obstacles": []})", "bounds");
  expect_input_refused(R"({"bounds": {"min": [0, 0], "max": [9, 9]}, "obstacles": [{"polygon": []}]})",
                       "obstacles[0].polygon");
  expect_input_refused(R"({"bounds": {"min": [0, 0], "max": [9, 9]}, "obstacles": [],
      "goals": [{"name": "far", "circle": {"center": [50, 50], "radius": 1}}]})",
                       "far");
}

TEST_F(CliBadInput, PosesOnTheCommandLineOfCompile) {
  expect_refused({"compile", "room.json", "-o", "x.krait", "--start", "1,2"}, "--start");
  expect_refused({"compile", "room.json", "-o", "x.krait", "--start", "nan,0,0"}, "--start");
  expect_refused({"compile", "room.json", "-o", "x.krait", "--start", "1e300,0,0"}, "start");
  expect_refused({"compile", "room.json", "-o", "x.krait", "--goal", "1,2,inf"}, "--goal");
  expect_refused({"compile", "room.json", "-o", "x.krait", "--goal", "1e300,2,1"}, "goal");
  expect_refused({"compile", "room.json", "-o", "x.krait", "--goal", "1,2,1e300"}, "goal");
  expect_refused({"compile", "room.json", "-o", "x.krait", "--goal", "90,90,1"}, "goal");
}

TEST_F(CliBadInput, Starts) {
  for (const char* start : {"nan,0,0", "0,inf,0", "1,2", "1,2,3,4", "1,2,", ",", "1e300,0,0", "3,5,1e30"}) {
    expect_plan_refused({"--start", start}, "--start");
  }
  expect_plan_refused({"--start", "nowhere"}, "west, north");
  expect_plan_refused({"--start", "-50,5,0"}, "start_outside: the start lies outside the bounds, -12,0 to 20,10 m\n");
  expect_plan_refused({"--start", "10,2,0"}, "start_in_collision");
  expect_plan_refused({"--start", "-11.9,5,0"}, "start_in_collision");
  expect_plan_refused({"--robot", "snake:3", "--start", "north"}, "trailer");
}

TEST_F(CliBadInput, Goals) {
  for (const char* goal : {"nan,0,1", "1,2,inf", "1,2", "1,2,0", "1,2,1e-9", "1,2,-1", "1e300,0,1", "3,5,1e300"}) {
    expect_plan_refused({"--goal", goal}, "--goal");
  }
  expect_plan_refused({"--goal", "nowhere"}, "east, south");
  expect_plan_refused({"--goal", "30,5,1"}, "outside");
  expect_plan_refused({"--goal", "10,2,0.2"},
                      "goal_in_obstacle: no free part of the goal is left: all that lies within 0.2 m of 10,2, is in "
                      "obstacles or outside: give another --goal or a larger radius (the robot is snake:15: --robot "
                      "asks for another)\n");
}

// As of a shell's variable that is not set: nothing is planned, judged or compiled with the default in its place.
TEST_F(CliBadInput, EmptyValues) {
  for (const char* option : {"--start", "--goal", "--datum", "--end-speed"}) {
    const std::string why = std::string("krait: ") + option + ": give a value, this one is empty (see krait ";
    expect_refused({"plan", "room.krait", option, ""}, why + "plan --help)\n");
    expect_refused({"verify", "room.json", "plan.json", option, ""}, why + "verify --help)\n");
  }
  expect_refused({"export", "room.json", "--datum", "", "--svg", "room.svg"}, "--datum: give a value");
  for (const char* option : {"--start", "--goal", "--datum", "--unknown", "--crop", "--for"}) {
    expect_refused({"compile", "room.json", "-o", "x.krait", option, ""},
                   std::string("krait-compile: ") + option + ": give a value, this one is empty (see --help)\n");
  }
  for (const char* option : {"--flash", "--ram"}) {
    expect_refused({"compile", "room.json", "-o", "x.krait", "--for", "car", option, ""},
                   std::string(option) + ": give a value");
  }
}

TEST_F(CliBadInput, Numbers) {
  expect_plan_refused({"--alpha", "nan"}, "alpha");
  expect_plan_refused({"--alpha", "1e999"}, "alpha");
  expect_plan_refused({"--alpha", "x"}, "alpha");
  expect_plan_refused({"--beta", "1"}, "beta");
  expect_plan_refused({"--beta", "0"}, "beta");
  expect_plan_refused({"--gamma", "-1"}, "gamma");
  expect_plan_refused({"--gamma", "inf"}, "gamma");
  expect_plan_refused({"--kappa", "0"}, "kappa");
  expect_plan_refused({"--kappa", "-1"}, "kappa");
  expect_plan_refused({"--kappa", "4294967297"}, "kappa");
  expect_plan_refused({"--clearance", "-1"}, "clearance");
  expect_plan_refused({"--clearance", "nan"}, "clearance");
  expect_plan_refused({"--iterations", "0"}, "iterations");
  expect_plan_refused({"--iterations", "-1"}, "iterations");
  for (const char* useless : {"-1", "nan", "fast"}) {
    expect_plan_refused({"--end-speed", useless}, "krait: --end-speed: give metres a second, 0 or more, or inf, not " +
                                                      std::string(useless) + " (see krait plan --help)\n");
  }
  expect_plan_refused({"--time-limit", "0"}, "time-limit");
  expect_plan_refused({"--time-limit", "-1"}, "time-limit");
  expect_plan_refused({"--time-limit", "nan"}, "time-limit");
  expect_plan_refused({"--seed", "-1"}, "seed");
  expect_plan_refused({"--seed", "1.5"}, "seed");
  expect_plan_refused({"--seed", "18446744073709551616"}, "seed");
  expect_plan_refused({"--seed", ""}, "seed");
}

TEST_F(CliBadInput, ATimeStepThatIsTooLongIsToldTheLongest) {
  write("fast.json", R"({"model": "car", "parameters": {"max_speed": 93}})");
  const auto plan = [&](const char* dt) { return krait({"plan", "room.krait", "--robot", "fast.json", "--dt", dt}); };
  const Outcome refused = plan("0.045");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("dt: at most 0.044 s for a robot so fast and so short: try --dt 0.044\n"));
  EXPECT_LE(plan("0.044").code, 1);
}

TEST_F(CliBadInput, ARobotThatNoTimeStepSuitsIsCalledThat) {
  write("fast.json", R"({"model": "truck", "links": 2, "parameters": {"max_speed": 10000, "hitch_length": 0.01}})");
  const Outcome refused = krait({"plan", "room.krait", "--robot", "fast.json"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("bad_argument: dt: none of 0.001 s or more: the robot changes too fast to be"));
}

TEST_F(CliBadInput, Memory) {
  expect_plan_refused({"--memory", "0"}, "arena_too_small");
  expect_plan_refused({"--memory", "1"}, "arena_too_small");
  for (const char* memory : {"12X", "", "K", "-1", "1.5M", "99999999999G", "99999999999999999999"}) {
    expect_plan_refused({"--memory", memory}, "memory");
  }
}

TEST_F(CliBadInput, RobotsByName) {
  expect_plan_refused({"--robot", "tank"}, "tank");
  expect_plan_refused({"--robot", "snake"}, "snake:2");
  for (const char* robot : {"snake:26", "snake:-1", "snake:", "snake:1.5", "snake:99999999999", "truck:x"}) {
    expect_plan_refused({"--robot", robot}, "from 0 to 25");
  }
  expect_plan_refused({"--robot", "car:1"}, "no trailers");
}

TEST_F(CliBadInput, RobotsByFile) {
  expect_robot_refused("", "empty");
  expect_robot_refused("nonsense", "JSON");
  expect_robot_refused("[]", "robot.json");
  expect_robot_refused("{}", "model");
  expect_robot_refused(R"({"model": "tank"})", "tank");
  expect_robot_refused(R"({"model": "snake"})", "links");
  expect_robot_refused(R"({"model": "snake", "links": 26})", "links");
  expect_robot_refused(R"({"model": "snake", "links": -1})", "links");
  expect_robot_refused(R"({"model": "car", "parameters": {"body_length": -1}})", "body_length");
  expect_robot_refused(R"({"model": "car", "parameters": {"body_length": NaN}})", "JSON");
  expect_robot_refused(R"({"model": "car", "parameters": {"max_speed": 0}})", "max_speed");
  expect_robot_refused(R"({"model": "car", "parameters": {"wings": 2}})", "wings");
  expect_robot_refused(R"({"model": "car", "bodies": []})", "bodies");
  expect_robot_refused(R"({"model": "car", "bodies": [{"polygon": [[0, 0], [1, 0]]}]})", "polygon");
  expect_robot_refused(R"({"model": "car", "bodies": [{"polygon": [[0, 0], [1, 0], [2, 0]]}]})", "convex");
}

TEST_F(CliBadInput, OutputsThatCannotBeWritten) {
  std::filesystem::create_directory(path("folder"));
  for (const char* option : {"-o", "--csv", "--svg", "--png", "--html"}) {
    expect_refused({"plan", "room.krait", "--robot", "car", option, "no/such/file"}, "no/such/file");
    expect_refused({"plan", "room.krait", "--robot", "car", option, "folder"}, "folder");
  }
  for (const char* option : {"-o", "--csv"}) {
    expect_refused({"plan", "room.krait", "--robot", "car", option, "/dev/full"}, "/dev/full");
  }
  for (const char* output : {"no/such/file", "folder", "/dev/full"}) {
    expect_refused({"compile", "room.json", "-o", output}, output);
    expect_refused({"scene", "gates", "-o", output}, output);
  }
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(CliBadInput, OutputsWithoutAName) {
  for (const char* option : {"-o", "--csv", "--svg", "--png", "--html"}) {
    expect_refused({"plan", "room.krait", "--robot", "car", option, ""}, "give a file name, this one is empty");
    expect_refused({"plan", "room.krait", "--robot", "car", option, "-"}, "/dev/stdout is standard output");
  }
  expect_refused({"compile", "room.json", "-o", ""}, "give a file name");
  expect_refused({"scene", "gates", "-o", ""}, "give a file name");
  for (const char* option : {"--geojson", "--svg", "--json"})
    expect_refused({"export", "room.json", option, ""}, "give a file name");
  for (const char* option : {"--svg", "--png", "--cpp"})
    expect_refused({"robot", "car", option, ""}, "give a file name");
}

TEST_F(CliBadInput, OptionsGivenTwice) {
  expect_refused({"plan", "room.krait", "--goal", "7,7,1", "--goal", "7,7,2"},
                 "krait: --goal is given more than once: give it once (see krait plan --help)\n");
  expect_refused({"compile", "room.json", "-o", "a.krait", "--start", "1,1,0", "--start", "2,2,0"},
                 "krait-compile: --start is given more than once: give it once (see --help)\n");
}

TEST_F(CliBadInput, APictureThatCannotBeWrittenLeavesTheAnswer) {
  for (const char* option : {"--svg", "--png", "--html"}) {
    const Outcome outcome = krait({"plan", "room.krait", "--robot", "car", option, "/dev/full"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.output, HasSubstr("solved: car"));
    EXPECT_THAT(outcome.errors, HasSubstr("/dev/full"));
  }
}

TEST_F(CliBadInput, OneOutputThatCannotBeWrittenKeepsTheOthersAway) {
  expect_refused({"plan", "room.krait", "--robot", "car", "-o", "plan.json", "--csv", "no/such/file"}, "no/such/file");
}

TEST_F(CliBadInput, AMapInPlaceOfASceneIsToldToBeCompiled) { expect_refused({"info", "room.json"}, "krait compile"); }

TEST_F(CliBadInput, AMapOrAPlanInPlaceOfARobotIsNamed) {
  expect_robot_refused(json("room.json").dump(), "is a map, not a robot: give it as the MAP of krait plan MAP --robot");
  expect_robot_refused(R"({"type": "FeatureCollection", "features": []})", "is a map, not a robot");
  expect_robot_refused(R"({"format": "krait-plan", "controls": []})", "is a plan, not a robot: the object that");
}

TEST_F(CliBadInput, AMapOfAnyFormatInPlaceOfARobotIsNamed) {
  for (const std::string& map : {std::string("type octile\nheight 1\n"), std::string("<svg/>"),
                                 read_text(path("room.krait")), std::string(R"({"bounds": )")}) {
    expect_robot_refused(map, "robot.json: is a map, not a robot: give it as the MAP of krait plan MAP --robot ROBOT");
  }
  write("room.yaml", "image: room.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n");
  expect_plan_refused({"--robot", "room.yaml"}, "room.yaml: is a map, not a robot");
  expect_refused({"robot", "room.yaml"}, "room.yaml: is a map, not a robot");
  expect_refused({"compile", "room.json", "--for", "room.yaml", "-o", "a.krait"}, "room.yaml: is a map, not a robot");
}

TEST_F(CliBadInput, AnImageOrAnothersRobotInPlaceOfARobotIsNamed) {
  expect_robot_refused("P5 2000 1000 255\n" + std::string(2'000'000, 'x'),
                       "is an image, not a robot: give the map's YAML file, which names it, as the MAP of krait plan");
  expect_robot_refused("<?xml version=\"1.0\"?>\n<robot name=\"arm\"/>\n",
                       "is a robot's URDF, which is not read: write");
  expect_robot_refused("shape: box\ndynamics: unicycle1\n", "is a robot of dynobench, which is not read: write");
}

TEST_F(CliBadInput, StandardOutputThatIsFullIsSaid) {
  for (const char* command : {"krait info room.krait", "krait --version", "krait --help", "krait plan --help",
                              "krait compile --help", "krait-compile --help"}) {
    const Outcome outcome =
        run_program("/bin/bash", {"-c", "exec " + test::program_path(command) + " >/dev/full"}, directory());
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_THAT(outcome.errors, MatchesRegex("krait(-compile)?: standard output cannot be written\n")) << command;
  }
}

}  // namespace
}  // namespace krait::host
