// SPDX-License-Identifier: Apache-2.0
// The firmware of a ROBOT.json finds the plan of krait plan, improved or not, and says in one line what it does not
// plan.
#include <nlohmann/json.hpp>

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
  expect_firmware_refuses({"--start", "0,0,0"},
                          "start_in_collision: the robot has no room at the start: ask with another --start, or with "
                          "less --clearance");
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
