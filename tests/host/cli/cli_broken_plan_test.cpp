// SPDX-License-Identifier: Apache-2.0
// krait verify on a plan of krait's own that was broken on purpose, field by field: exit code 1 and the reason.
#include <functional>

#include "host/cli/program.hpp"

namespace krait::host {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

struct Broken {
  std::string name;
  std::function<void(ordered_json&)> how;
  std::string mention;
};

void add(ordered_json& number, double difference) { number = number.get<double>() + difference; }

std::vector<Broken> all_broken() {
  return {{"state_moved", [](auto& p) { add(p["states"][5][0], 0.02); }, "from where the controls lead"},
          {"last_state_moved", [](auto& p) { add(p["states"].back()[1], 0.02); }, "from where the controls lead"},
          {"control_changed", [](auto& p) { add(p["controls"][4][0], 1.0); }, "state 5: "},
          {"speed_over_its_limit", [](auto& p) { p["states"][6][3] = 2.6; }, "state 6: v differs by "},
          {"control_over_its_limit", [](auto& p) { p["controls"][2][1] = 4.1; }, "beyond its limit"},
          {"first_state_left_out",
           [](auto& p) {
             p["states"].erase(0);
             p["controls"].erase(0);
           },
           "start"},
          {"last_steps_left_out",
           [](auto& p) {
             for (int i = 0; i < 20; ++i) {
               p["states"].erase(p["states"].size() - 1);
               p["controls"].erase(p["controls"].size() - 1);
             }
           },
           "goal"},
          {"a_step_left_out",
           [](auto& p) {
             p["states"].erase(20);
             p["controls"].erase(20);
           },
           "from where the controls lead"},
          {"a_step_twice",
           [](auto& p) {
             p["states"].insert(p["states"].begin() + 20, p["states"][20]);
             p["controls"].insert(p["controls"].begin() + 20, p["controls"][20]);
           },
           "from where the controls lead"},
          {"controls_in_another_order", [](auto& p) { std::swap(p["controls"][3], p["controls"][30]); }, "step"},
          {"time_step_longer", [](auto& p) { p["dt"] = 0.11; }, "dt: is 0.11 s, asked 0.1 s"},
          {"origin_moved", [](auto& p) { p["origin"][0] = 0.1; }, "start"},
          {"goal_moved", [](auto& p) { add(p["goal"]["polygon"][0][0], -0.5); }, "goal"},
          {"robot_faster", [](auto& p) { p["robot"]["parameters"]["max_speed"] = 3.0; }, "max_speed"},
          {"robot_thinner", [](auto& p) { add(p["robot"]["bodies"][0]["polygon"][0][1], 0.1); }, "body 0"},
          {"straight_through_the_wall",
           [](auto& p) {
             for (auto& state : p["states"]) state[1] = 2.0;
           },
           "clearance 0 m"},
          {"out_of_bounds",
           [](auto& p) {
             for (auto& state : p["states"]) add(state[1], 6.0);
           },
           "bounds"},
          {"steps_miscounted", [](auto& p) { p["statistics"]["plan_steps"] = 12; },
           "statistics: plan_steps is 12, the plan's is "},
          {"said_to_be_shorter", [](auto& p) { add(p["statistics"]["plan_length_m"], -0.01); },
           "statistics: plan_length_m is "},
          {"said_to_be_quicker", [](auto& p) { add(p["statistics"]["plan_duration_s"], -0.01); },
           "statistics: plan_duration_s is "},
          {"said_to_end_faster", [](auto& p) { p["statistics"]["plan_end_speed_m_s"] = 0.25; },
           "statistics: plan_end_speed_m_s is 0.25, the plan's is "},
          {"length_in_words", [](auto& p) { p["statistics"]["plan_length_m"] = "short"; },
           "statistics: plan_length_m is \"short\", the plan's is "},
          {"length_in_words_that_turn_around", [](auto& p) { p["statistics"]["plan_length_m"] = "5\u202e4"; },
           "statistics: plan_length_m is \"5\\u202E4\", the plan's is "},
          {"hash_of_another", [](auto& p) { p["statistics"]["hash"] = "0123456789abcdef"; },
           "statistics: hash is \"0123456789abcdef\", that of states and controls is \""},
          {"state_within_rounding", [](auto& p) { add(p["states"][5][0], 1e-5); }, "statistics: hash is "},
          {"nothing_solved",
           [](auto& p) {
             p["status"] = "no_route";
             p["states"] = p["controls"] = ordered_json::array();
           },
           "no_route"}};
}

class CliBrokenPlan : public CliTest {};

TEST_F(CliBrokenPlan, IsCaughtWhateverIsBroken) {
  expect_done({"plan", "room.krait", "--robot", "car", "-o", "plan.json"});
  expect_done({"verify", "room.json", "plan.json", "--robot", "car"});
  const ordered_json sound = json("plan.json");
  ASSERT_GT(sound.at("controls").size(), 40U);
  for (const Broken& broken : all_broken()) {
    SCOPED_TRACE(broken.name);
    ordered_json plan = sound;
    broken.how(plan);
    write("broken.json", plan.dump());
    const Outcome outcome = krait({"verify", "room.json", "broken.json", "--robot", "car", "--start", "west", "--all"});
    EXPECT_EQ(outcome.code, 1) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr(broken.mention));
    EXPECT_THAT(outcome.output, HasSubstr("the plan does not hold"));
  }
}

// However many steps there are, one more is wrong; a length of so many may be rounded in its last digits.
TEST_F(CliBrokenPlan, AStepTooManyIsCaughtInALongPlan) {
  expect_done({"plan", "room.krait", "--robot", "car", "--dt", "0.001", "--improve", "0", "-o", "plan.json"});
  ordered_json plan = json("plan.json");
  const auto steps = plan.at("statistics").at("plan_steps").get<std::size_t>();
  ASSERT_GT(steps, 4000U);
  expect_done({"verify", "room.json", "plan.json", "--robot", "car", "--dt", "0.001"});
  plan["statistics"]["plan_steps"] = steps + 1;
  write("broken.json", plan.dump());
  const Outcome outcome = krait({"verify", "room.json", "broken.json", "--robot", "car", "--dt", "0.001"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output,
              HasSubstr("plan_steps is " + std::to_string(steps + 1) + ", the plan's is " + std::to_string(steps)));
}

TEST_F(CliBrokenPlan, IsCaughtWhenAnotherTimeStepWasAsked) {
  expect_done({"plan", "room.krait", "--robot", "car", "-o", "plan.json"});
  expect_done({"verify", "room.json", "plan.json", "--robot", "car", "--dt", "0.1"});
  const Outcome outcome = krait({"verify", "room.json", "plan.json", "--robot", "car", "--dt", "0.2"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("dt: is 0.1 s, asked 0.2 s"));
  for (const char* useless : {"0", "1.5", "nan", "-0.1"}) {
    const Outcome refused = krait({"verify", "room.json", "plan.json", "--robot", "car", "--dt", useless});
    EXPECT_EQ(refused.code, 2) << useless;
    EXPECT_THAT(refused.errors, HasSubstr("--dt: give seconds from 0.001 to 1, not "));
  }
}

// The map changed after the plan was made.
TEST_F(CliBrokenPlan, AVerdictForTheDefaultRobotSaysSo) {
  expect_done({"plan", "room.krait", "--robot", "car", "-o", "plan.json"});
  const std::string words = "the default: --robot asks for another";
  const Outcome outcome = krait({"verify", "room.json", "plan.json"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("judged for snake:15, " + words));
  EXPECT_THAT(krait({"verify", "room.json", "plan.json", "--robot", "truck:1"}).output, testing::Not(HasSubstr(words)));
}

TEST_F(CliBrokenPlan, IsCaughtWhenTheMapHasOneWallMore) {
  expect_done({"plan", "room.krait", "--robot", "car", "-o", "plan.json"});
  ordered_json room = json("room.json");
  room["obstacles"].push_back({{"box", {{"center", {10, 5}}, {"size", {0.01, 2}}, {"angle", 0}}}});
  write("walled.json", room.dump());
  const Outcome outcome = krait({"verify", "walled.json", "plan.json", "--robot", "car"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("obstacles[2]"));
}

}  // namespace
}  // namespace krait::host
