// SPDX-License-Identifier: Apache-2.0
// The firmware of a ROBOT.json finds the first plan of krait plan, and says in one line what it does not plan.
#include <nlohmann/json.hpp>

#include "host/cli/program.hpp"
#include "host/workspace/printed.hpp"
#include "krait/parameters.hpp"

namespace krait::host {
namespace {

using Arguments = std::vector<std::string>;

const std::string kVan = KRAIT_SOURCE_DIR "/tests/targets/robots/van.json";

class CompiledFirmware : public CliTest {
 protected:
  Outcome firmware(Arguments arguments, const std::string& scene = "room.krait") const {
    arguments.insert(arguments.begin(), {"--scene", scene});
    return run_program(KRAIT_BIN_DIR "/firmware_van", arguments, directory());
  }

  // Both find the same plan, by that query and with those parameters.
  void expect_same_plan(const Arguments& query) const {
    Arguments arguments = {"plan", "room.krait", "--robot", kVan, "--memory",
                           "1M",   "--improve",  "0",       "-o", "plan.json"};
    arguments.insert(arguments.end(), query.begin(), query.end());
    expect_done(arguments);
    Arguments words = {"--memory", "1M"};
    words.insert(words.end(), query.begin(), query.end());
    const Outcome outcome = firmware(words);
    ASSERT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
    const nlohmann::json answer = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(answer.at("status"), "solved");
    EXPECT_EQ(answer.at("robot"), "van");
    EXPECT_EQ(answer.at("hash"), json("plan.json").at("statistics").at("hash"));
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

TEST_F(CompiledFirmware, PlansForItsRobotOnly) {
  expect_firmware_refuses({"--robot", "car"}, "--robot: this firmware plans for another robot");
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
