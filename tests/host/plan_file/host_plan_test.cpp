// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <bit>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "../scratch.hpp"
#include "host/input/json.hpp"
#include "host/plan_file/plan_file.hpp"
#include "host/plan_file/plan_table.hpp"

namespace krait::host {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PlanFile example() {
  PlanFile plan;
  plan.status = "solved";
  plan.scene = "gates";
  plan.seed = std::numeric_limits<std::uint64_t>::max();
  plan.planner = "adaptive";
  plan.robot = parse_robot("snake:1");
  plan.dt = 0.1;
  plan.goal_name = "goal";
  plan.goal_polygon = {{0, 0}, {1, 0}, {0, 1}};
  plan.state_names = state_names(plan.robot);
  plan.states = {{0, 0, 0, 0, 0, 0}, {0.1F, -0.0F, 1e-40F, 3.4e38F, 1.0F / 3, -2.5F}};
  plan.controls = {{0.5F, -4}};
  plan.origin = {1234.5, -6};
  plan.statistics =
      std::make_shared<const Json>(Json{{"iterations", 7}, {"time_s", 0.25}, {"hash", "0123456789abcdef"}});
  return plan;
}

class PlanTest : public ScratchTest {
 protected:
  PlanFile read_back(const PlanFile& plan) const { return read_plan(write("p.json", to_json(plan).dump())); }
  std::string read_error(const Json& json) const {
    return error_of([&] { read_plan(write("p.json", json.dump())); });
  }
};

TEST_F(PlanTest, ReadsBackWhatWasWritten) {
  const PlanFile plan = example();
  const PlanFile copy = read_back(plan);
  EXPECT_EQ(to_json(copy), to_json(plan));
  EXPECT_EQ(copy.seed, plan.seed);
  EXPECT_EQ(copy.origin.x, 1234.5);
}

TEST_F(PlanTest, ATableHasAStateALineAndTheControlThatItIsLeftWith) {
  PlanFile plan = example();
  plan.states[1] = {0.5F, -0.25F, 1, 2, 1.0F / 3, -2.5F};
  EXPECT_EQ(plan_table(plan),
            "t,x,y,theta0,v,psi,theta1,acceleration,steering_rate\n"
            "0,1234.5,-6,0,0,0,0,0.5,-4\n"
            "0.1,1235,-6.25,1,2,0.333333343,-2.5,,\n");
}

TEST_F(PlanTest, ATableOfAPlanFarFromTheOriginKeepsItsMillimetres) {
  PlanFile plan = example();
  plan.origin = {5'000'000, 0};
  plan.states = {{0.125F, 0.125F, 0, 0, 0, 0}};
  plan.controls.clear();
  EXPECT_THAT(plan_table(plan), HasSubstr("\n0,5000000.125,0.125,0,0,0,0,,\n"));
}

TEST_F(PlanTest, AHeadingOfTheGoalReadsBack) {
  PlanFile plan = example();
  EXPECT_FALSE(to_json(plan)["goal"].contains("heading"));
  plan.goal_facing = GoalFacing{-1.25, 0.1, true, {}};
  EXPECT_FALSE(to_json(plan)["goal"].contains("hitch_tolerance"));
  plan.goal_facing->hitches = 0.2;
  const PlanFile copy = read_back(plan);
  EXPECT_EQ(to_json(copy), to_json(plan));
  ASSERT_TRUE(copy.goal_facing);
  EXPECT_EQ(copy.goal_facing->heading, -1.25);
  EXPECT_EQ(copy.goal_facing->tolerance, 0.1);
  EXPECT_TRUE(copy.goal_facing->either_way);
  EXPECT_EQ(copy.goal_facing->hitches, 0.2);
  EXPECT_FALSE(read_back(example()).goal_facing);
}

TEST_F(PlanTest, AWrongHeadingIsNamed) {
  PlanFile plan = example();
  plan.goal_facing = GoalFacing{1, 0.1, false, 0.2};
  const auto error = [&](const char* key, const Json& value) {
    Json json = to_json(plan);
    json["goal"][key] = value;
    return read_error(json);
  };
  EXPECT_THAT(error("heading", "north"), HasSubstr("goal.heading"));
  EXPECT_THAT(error("heading", 1e9), HasSubstr("goal.heading"));
  EXPECT_THAT(error("heading_tolerance", -1), HasSubstr("goal.heading_tolerance"));
  EXPECT_THAT(error("either_way", 1), HasSubstr("goal.either_way: must be true or false"));
  EXPECT_THAT(error("hitch_tolerance", nullptr), HasSubstr("goal.hitch_tolerance"));
}

TEST_F(PlanTest, ItsTextsHaveNoControlCharacters) {
  const std::string expected = ": must be a text without control characters, is \"a\\u009bb\"";
  for (const char* key : {"status", "scene", "planner"}) {
    Json json = to_json(example());
    json[key] =
        "a\xC2\x9B"
        "b";
    EXPECT_EQ(read_error(json), path("p.json") + ": " + key + expected);
  }
  Json json = to_json(example());
  json["goal"]["name"] =
      "a\xC2\x9B"
      "b";
  EXPECT_EQ(read_error(json), path("p.json") + ": goal.name" + expected);
}

TEST_F(PlanTest, EveryFloatKeepsItsBits) {
  PlanFile plan = example();
  plan.robot = parse_robot("unicycle");
  plan.state_names = state_names(plan.robot);
  plan.states.clear();
  plan.controls.clear();
  std::mt19937 random(1);
  const auto any = [&random] {
    for (;;) {
      const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
      if (std::isfinite(value)) return value;
    }
  };
  for (int i = 0; i < 20000; ++i) plan.states.push_back({any(), any(), any()});
  plan.controls.assign(plan.states.size() - 1, {-0.0F, std::numeric_limits<float>::denorm_min()});
  const PlanFile copy = read_back(plan);
  ASSERT_EQ(copy.states.size(), plan.states.size());
  for (std::size_t i = 0; i < plan.states.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(copy.states[i][k]), std::bit_cast<std::uint32_t>(plan.states[i][k]));
    }
  }
  EXPECT_TRUE(std::signbit(copy.controls[0][0]));
}

TEST_F(PlanTest, FloatsAreWrittenShort) {
  const std::string text = to_json(example())["states"].dump();
  EXPECT_THAT(text, HasSubstr("[0.1,-0.0,1e-40,3.4e+38,0.33333334,-2.5]"));
}

TEST_F(PlanTest, AnUnsolvedPlanHasEmptyArrays) {
  PlanFile plan = example();
  plan.status = "no_route";
  const Json json = to_json(plan);
  EXPECT_TRUE(json["states"].is_array() && json["states"].empty());
  EXPECT_TRUE(json["controls"].is_array() && json["controls"].empty());
  EXPECT_EQ(read_back(plan).status, "no_route");
}

TEST_F(PlanTest, NothingUnsayableIsWritten) {
  PlanFile plan = example();
  plan.states[1][2] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(to_json(plan), std::logic_error);
  plan = example();
  plan.statistics = std::make_shared<const Json>(Json{{"time_s", std::numeric_limits<double>::infinity()}});
  EXPECT_THROW(to_json(plan), std::logic_error);
  plan = example();
  plan.controls.clear();
  EXPECT_THROW(to_json(plan), std::logic_error);
}

TEST_F(PlanTest, AWrongFieldIsNamed) {
  const Json good = to_json(example());
  const auto changed = [&](const char* pointer, const Json& value) {
    Json json = good;
    json[Json::json_pointer(pointer)] = value;
    return read_error(json);
  };
  EXPECT_THAT(changed("/format", "plan"), HasSubstr("is not a plan"));
  EXPECT_THAT(changed("/version", 2), HasSubstr("version: must be a whole number from 1 to 1"));
  EXPECT_THAT(changed("/seed", -1), HasSubstr("seed"));
  EXPECT_THAT(changed("/dt", 0), HasSubstr("dt: must be"));
  EXPECT_THAT(changed("/robot/parameters/max_speed", -1), HasSubstr("robot.parameters.max_speed"));
  EXPECT_THAT(changed("/goal/polygon", Json::array()), HasSubstr("goal.polygon"));
  EXPECT_THAT(changed("/state_names/2", "phi"), HasSubstr("state_names"));
  EXPECT_THAT(changed("/control_names/1", "phi"), HasSubstr("control_names: are not those of the robot's model"));
  EXPECT_THAT(changed("/states/1/3", 1e39), HasSubstr("states[1][3]: must be a number"));
  EXPECT_THAT(changed("/states/1/3", nullptr), HasSubstr("states[1][3]: must be a number"));
  EXPECT_THAT(changed("/states/0", Json::array()), HasSubstr("states[0]: must have 6 numbers"));
  EXPECT_THAT(changed("/controls/0", {1}), HasSubstr("controls[0]: must have 2 numbers"));
  EXPECT_THAT(changed("/controls", Json::array()), HasSubstr("states: must be one more than the controls"));
  EXPECT_THAT(changed("/status", "no_route"), HasSubstr("only in a solved plan"));
  Json unsolved = good;
  unsolved["status"] = "no_route";
  unsolved["states"] = Json::array();
  EXPECT_THAT(read_error(unsolved), HasSubstr("only in a solved plan"));
  EXPECT_THAT(changed("/origin", {1}), HasSubstr("origin: must be [x, y]"));
  EXPECT_THAT(read_error(Json::array()), HasSubstr("is not a plan"));
}

TEST_F(PlanTest, EveryMissingFieldIsNamed) {
  const Json good = to_json(example());
  for (const auto& item : good.items()) {
    Json json = good;
    json.erase(item.key());
    if (item.key() == "control_names") continue;  // those of the model, which older plans leave out
    EXPECT_THAT(read_error(json), HasSubstr(item.key()));
  }
}

TEST_F(PlanTest, ControlsMayBeWithoutNames) {
  Json json = to_json(example());
  EXPECT_EQ(json.at("control_names").size(), 2U);
  json.erase("control_names");
  EXPECT_EQ(read_error(json), "");
}

TEST_F(PlanTest, ATruncatedFileIsRefusedAtEveryLength) {
  const std::string text = to_json(example()).dump();
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_NE(error_of([&] { read_plan(write("p.json", text.substr(0, length))); }), "") << length;
  }
}

TEST(StateNames, AreThoseOfTheModel) {
  EXPECT_THAT(state_names(parse_robot("truck:2")), ElementsAre("x", "y", "theta0", "v", "psi", "theta1", "theta2"));
  EXPECT_THAT(state_names(parse_robot("kinematic_truck:1")), ElementsAre("x", "y", "theta0", "theta1"));
  EXPECT_THAT(state_names(parse_robot("car")), ElementsAre("x", "y", "theta0", "v", "psi"));
  EXPECT_THAT(state_names(parse_robot("unicycle")), ElementsAre("x", "y", "theta"));
  EXPECT_THAT(state_names(parse_robot("diff_drive")), ElementsAre("x", "y", "theta", "left", "right"));
}

}  // namespace
}  // namespace krait::host
