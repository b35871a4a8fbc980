// SPDX-License-Identifier: Apache-2.0
// The firmware of a ROBOT.json finds the plan of krait plan, improved or not, and says in one line what it does not
// plan.
#include <nlohmann/json.hpp>

#include "firmware/request.hpp"
#include "host/cli/program.hpp"
#include "host/workspace/printed.hpp"
#include "krait/parameters.hpp"
#include "paths.hpp"

namespace krait::host {
namespace {

using Arguments = std::vector<std::string>;

std::string van() { return test::source_path("tests/targets/robots/van.json"); }

class CompiledFirmware : public CliTest {
 protected:
  Outcome firmware(Arguments arguments, const std::string& scene = "room.krait") const {
    arguments.insert(arguments.begin(), {"--scene", scene});
    return run_program(test::program_path("firmware_van"), arguments, directory());
  }

  // Both find the same plan, by that query and with those parameters. Returns the firmware's answer.
  nlohmann::json expect_same_plan(const Arguments& query, const std::string& improve = "0") const {
    Arguments words = {"--memory", "1M", "--improve", improve};
    words.insert(words.end(), query.begin(), query.end());
    Arguments arguments = {"plan", "room.krait", "--robot", van(), "-o", "plan.json"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    expect_done(arguments);
    const Outcome outcome = firmware(words);
    EXPECT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
    nlohmann::json answer = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(answer.at("status"), "solved");
    EXPECT_EQ(answer.at("robot"), "van");
    EXPECT_EQ(answer.at("hash"), json("plan.json").at("statistics").at("hash"));
    return answer;
  }

  // Its line begins so, and its answer has those fields. Returns the answer.
  nlohmann::json expect_explained(const Arguments& arguments, int code, const std::string& line,
                                  const nlohmann::json& fields, const std::string& scene = "room.krait") const {
    const Outcome outcome = firmware(arguments, scene);
    EXPECT_EQ(outcome.code, code);
    EXPECT_THAT(outcome.output, testing::StartsWith("krait: " + line));
    const auto end = outcome.output.find('\n') + 1;
    nlohmann::json answer = nlohmann::json::parse(outcome.output.substr(end));
    for (const auto& [name, value] : fields.items()) EXPECT_EQ(answer.at(name), value) << name;
    return answer;
  }

  void expect_firmware_refuses(const Arguments& arguments, const std::string& line,
                               const std::string& scene = "room.krait") const {
    const Outcome outcome = firmware(arguments, scene);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.output.substr(0, outcome.output.find('\n')), "krait: " + line);
  }
};

TEST_F(CompiledFirmware, FindsTheWorkstationsPlan) { expect_same_plan({"--clearance", "0.001"}); }

TEST_F(CompiledFirmware, KeepsTheClearanceAndTheTimeStepThatAreAskedFor) {
  expect_same_plan({"--clearance", "0.15"});
  expect_same_plan({"--clearance", "0.05", "--dt", "0.06", "--seed", "3"});
  expect_same_plan({"--clearance", "0.001", "--start", "3,8,0.5", "--goal", "16,2.5,0.75", "--heading", "-0.4"});
}

TEST_F(CompiledFirmware, ImprovesItsPlanAsTheWorkstationDoes) {
  const nlohmann::json first = expect_same_plan({"--clearance", "0.001", "--seed", "2"});
  EXPECT_FALSE(first.contains("improvements"));
  const nlohmann::json improved = expect_same_plan({"--clearance", "0.001", "--seed", "2"}, "2.5");
  const nlohmann::json host = json("plan.json").at("statistics");
  EXPECT_GE(improved.at("improvements"), 1);
  EXPECT_EQ(improved.at("improvements"), host.at("improvements"));
  EXPECT_EQ(improved.at("collision_checks"), host.at("collision_checks"));
  EXPECT_EQ(improved.at("first_plan_steps"), first.at("plan_steps"));
  EXPECT_EQ(improved.at("first_plan_length_m"), first.at("plan_length_m"));
  EXPECT_EQ(improved.at("first_plan_duration_s"), first.at("plan_duration_s"));
  EXPECT_LT(improved.at("plan_steps"), first.at("plan_steps"));
}

TEST_F(CompiledFirmware, AsksForTheMemoryThatImprovementTakes) {
  const Outcome refused = firmware({"--memory", "8K", "--improve", "1"});
  EXPECT_EQ(refused.code, 2);
  const auto answer = nlohmann::json::parse(refused.output.substr(refused.output.find('{')));
  const auto needed = answer.at("bytes_needed").get<std::uint64_t>();
  EXPECT_NE(firmware({"--memory", std::to_string(needed), "--iterations", "9", "--improve", "1"}).code, 2);
  EXPECT_EQ(firmware({"--memory", std::to_string(needed - 8), "--iterations", "9", "--improve", "1"}).code, 2);
}

TEST_F(CompiledFirmware, IsBuiltWithoutImprovementToo) {
  const auto ask = [&](const std::string& improve) {
    return run_program(test::program_path("firmware_van_first"), {"--scene", "room.krait", "--improve", improve},
                       directory());
  };
  EXPECT_EQ(ask("0").code, 0);
  EXPECT_EQ(ask("1").code, 2);
  EXPECT_EQ(ask("1").output, "krait: --improve: this firmware is built with KRAIT_IMPROVE=OFF\n");
}

TEST_F(CompiledFirmware, PlansForItsRobotOnly) {
  expect_firmware_refuses({"--robot", "car"}, "--robot: this firmware plans for another robot, van");
  EXPECT_EQ(firmware({"--robot", "van"}).code, 0);
}

TEST_F(CompiledFirmware, NamesWhatIsNoOption) {
  expect_firmware_refuses({"--seed", "2", "--end-speed", "1"},
                          std::string("unknown option: --end-speed") + firmware::kKnownOptions);
}

TEST_F(CompiledFirmware, NamesWhatIsOutOfItsRange) {
  const auto range = [](Argument argument) {
    const ParameterRange numbers = Parameters::range(argument);
    return printed("from %.4g to %.4g ", decimal(numbers.least), decimal(numbers.most));
  };
  expect_firmware_refuses({"--clearance", "11"},
                          "bad_argument: clearance: --clearance is " + range(Argument::clearance) + "metres");
  expect_firmware_refuses({"--dt", "1.5"}, "bad_argument: dt: --dt is " + range(Argument::dt) + "seconds");
}

TEST_F(CompiledFirmware, SaysWhatToDoAboutAStartOrAGoalThatCannotBeUsed) {
  expect_firmware_refuses({"--start", "-40,5,0"},
                          "start_outside: the start lies outside of the scene: ask with another --start");
  const std::vector<std::string> in_a_wall = {"--scene", "room.krait", "--start", "10,2,0"};
  const Outcome short_of_words = run_program(test::program_path("firmware_van_first"), in_a_wall, directory());
  EXPECT_THAT(short_of_words.output,
              testing::StartsWith("krait: start_in_collision: the robot has no room at the start: ask with another "
                                  "--start, or with less --clearance\n"));
}

TEST_F(CompiledFirmware, SaysWhatTheRobotMeetsAtItsStart) {
  expect_explained({"--start", "10,2,0"}, 2, "start_in_collision: body 0 overlaps an obstacle at (9.",
                   {{"contact", "obstacle"}, {"contact_body", 0}, {"contact_distance_m", 0}});
  expect_explained({"--start", "-11.9,5,0"}, 2, "start_in_collision: body 0 reaches to or beyond the bounds at (-12",
                   {{"contact", "bounds"}, {"contact_distance_m", 0}});
  const auto near =
      expect_explained({"--start", "8,2,1.5707964", "--clearance", "1.2"}, 2,
                       "start_in_collision: the start does not keep the clearance: body 0 is 1.145 m from "
                       "an obstacle at (8.9",
                       {{"contact", "obstacle"}});
  EXPECT_NEAR(near.at("contact_distance_m"), 9.5 - 8 - 0.71 / 2, 1e-5);
  EXPECT_NEAR(near.at("contact_needed_m"), 1.2, 0.01);
}

TEST_F(CompiledFirmware, SaysWhereItsWayIsTooNarrow) {
  const double east = 8000;  // metres: a scene file has coordinates of its own there
  auto room = nlohmann::json::parse(read_text(path("room.json")));
  const auto move = [&](nlohmann::json& place) { place.at(0) = place.at(0).get<double>() + east; };
  for (const char* corner : {"min", "max"}) move(room.at("bounds").at(corner));
  for (auto& obstacle : room.at("obstacles")) {
    move(obstacle.at("box").at("center"));
    obstacle.at("box").at("size").at(1) = 5.4;  // leaves 0.6 m between the two
  }
  for (auto& goal : room.at("goals")) move(goal.at("box").at("center"));
  for (auto& start : room.at("starts")) move(start.at("position"));
  write("narrow.json", room.dump());
  expect_done({"compile", "narrow.json", "-o", "narrow.krait", "--tolerance", "0"});
  const auto narrow = expect_explained({}, 1, "no_route: every way to the goal is narrower than the robot: 0.6",
                                       {{"bottleneck_in_goal", 0}}, "narrow.krait");
  EXPECT_NEAR(narrow.at("bottleneck_m"), 0.6, 0.01);
  EXPECT_NEAR(narrow.at("bottleneck_needed_m"), 0.712, 1e-4);
  EXPECT_NEAR(narrow.at("bottleneck_x"), east + 10, 0.51);
  EXPECT_NEAR(narrow.at("bottleneck_y"), 5, 0.01);
  EXPECT_FALSE(narrow.contains("effort_tries"));
  const std::string blame = "grown by up to 0.200 m a side";
  EXPECT_THAT(firmware({}, "narrow.krait").output,
              testing::AllOf(testing::HasSubstr(" m at (80"), testing::Not(testing::HasSubstr(blame))));
  expect_done({"compile", "narrow.json", "-o", "grown.krait", "--tolerance", "0.4"});
  EXPECT_THAT(firmware({}, "grown.krait").output, testing::HasSubstr(blame));
}

// As far as the scene says, the obstacle may have been 0.4 m farther away.
TEST_F(CompiledFirmware, SaysWhatTheScenesToleranceMayHaveTaken) {
  expect_done({"compile", "room.json", "-o", "grown.krait", "--tolerance", "0.8"});
  const std::string blame =
      "; when the scene was compiled, obstacles were grown by up to 0.400 m a side, which may be why: --tolerance 0";
  const std::vector<std::string> close = {"--start", "8,2,1.5707964", "--clearance", "1.2"};
  EXPECT_THAT(firmware(close, "grown.krait").output, testing::HasSubstr(blame));
  EXPECT_THAT(firmware(close).output, testing::Not(testing::HasSubstr("grown")));
  const std::vector<std::string> closer = {"--start", "8,2,1.5707964", "--clearance", "1.7"};
  EXPECT_THAT(firmware(closer, "grown.krait").output, testing::Not(testing::HasSubstr("grown")));
}

TEST_F(CompiledFirmware, SaysWhereItsSearchTriedMost) {
  const auto vain = expect_explained({"--iterations", "1", "--clearance", "0.1"}, 1,
                                     "budget_used: the search tried most at (", {{"effort_tries", 1}});
  EXPECT_NEAR(vain.at("bottleneck_m"), 2, 0.01);
  EXPECT_NEAR(vain.at("effort_y"), 5, 5);
}

TEST_F(CompiledFirmware, SaysThatNoSceneLiesThere) {
  write("erased.krait", std::string(4096, '\xFF'));
  write("zeros.krait", std::string(4096, '\0'));
  write("other.krait", std::string(15, '\xFF') + std::string(4081, 'x'));
  const std::string load = ": load SCENE.krait to the board's SCENE";
  expect_firmware_refuses({}, "bad_scene: no scene lies there, only erased flash" + load, "erased.krait");
  expect_firmware_refuses({}, "bad_scene: no scene lies there, only zeros" + load, "zeros.krait");
  expect_firmware_refuses(
      {}, "bad_scene: section 255, element 0: not a whole scene file of this version (compile it again)",
      "other.krait");
}

TEST_F(CompiledFirmware, SaysWhereAStartComesFrom) {
  auto room = nlohmann::json::parse(read_text(path("room.json")));
  room["starts"] = nlohmann::json::array();
  write("bare.json", room.dump());
  expect_done({"compile", "bare.json", "-o", "bare.krait"});
  expect_firmware_refuses({},
                          "bad_argument: start: the scene has no start for this robot: compile with --start "
                          "X,Y,HEADING, or ask with it",
                          "bare.krait");
  EXPECT_EQ(firmware({"--start", "3,5,0"}, "bare.krait").code, 0);
}

}  // namespace
}  // namespace krait::host
