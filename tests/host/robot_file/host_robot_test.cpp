// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "../every_robot.hpp"
#include "../scratch.hpp"
#include "host/input/file.hpp"
#include "host/robot_file/robot_file.hpp"

namespace krait::host::host_robot_test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Pair;
using testing::StartsWith;
using testing::UnorderedElementsAre;

std::string parse_error(const std::string& text) {
  return error_of([&] { parse_robot(text); });
}

std::string read_error(const std::string& json) {
  const Json document = parse_json(json, "r.json");
  return error_of([&] { read_robot(Field(document, "r.json")); });
}

RobotSpec read(const std::string& json) {
  const Json document = parse_json(json, "r.json");
  return read_robot(Field(document, "r.json"));
}

void expect_box(const Ring& ring, double left, double right, double half_width) {
  ASSERT_EQ(ring.size(), 4U);
  EXPECT_NEAR(ring[0].x, left, 1e-12);
  EXPECT_NEAR(ring[0].y, -half_width, 1e-12);
  EXPECT_NEAR(ring[2].x, right, 1e-12);
  EXPECT_NEAR(ring[2].y, half_width, 1e-12);
}

std::string page_of(std::string model) {
  std::transform(model.begin(), model.end(), model.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return read_file(std::string(KRAIT_MODEL_PAGES "/") + model + ".md", 1U << 16U);
}

std::string row_of(const std::string& model, const std::string& parameter, double normal) {
  char number[32];
  std::snprintf(number, sizeof number, "%.8g", normal);
  const auto [least, most] = range_of(model, parameter);
  return "| `" + parameter + "` | " + number + " " + unit_of(model, parameter) + " | " + shown(least) + " to " +
         shown(most);
}

TEST(Robot, EveryModelHasAPageWithItsParametersAFigureAndASource) {
  for (const std::string& name : every_robot(1)) {
    const RobotSpec robot = parse_robot(name);
    const std::string page = page_of(robot.model);
    EXPECT_THAT(page, StartsWith("# " + robot.model + ": "));
    EXPECT_THAT(page, HasSubstr("- -> x")) << "the axis of its figure";
    EXPECT_THAT(page, AnyOf(HasSubstr("\nSource: "), HasSubstr("\nSources: ")));
    for (const std::string& parameter : own_parameters(robot)) {
      const std::string row = row_of(robot.model, parameter, robot.parameters.at(parameter));
      EXPECT_THAT(page, AnyOf(HasSubstr(row + " |\n"), HasSubstr(row + "; ")));
    }
  }
}

TEST(Robot, EveryParameterHasAUnitAndARangeAroundItsDefault) {
  for (const std::string& model : robot_models()) {
    for (const auto& [parameter, normal] : default_parameters(model)) {
      const auto [least, most] = range_of(model, parameter);
      EXPECT_NE(unit_of(model, parameter), "") << model << " " << parameter;
      EXPECT_LT(least, most) << model << " " << parameter;
      EXPECT_GE(normal, least) << model << " " << parameter;
      EXPECT_LE(normal, most) << model << " " << parameter;
    }
  }
}

TEST(Robot, SnakeAndTruckHaveTheDocumentedDefaults) {
  for (const char* text : {"snake:15", "truck:15"}) {
    const RobotSpec robot = parse_robot(text);
    EXPECT_EQ(robot.links, 15);
    EXPECT_THAT(robot.parameters,
                UnorderedElementsAre(Pair("body_length", 0.7), Pair("body_width", 0.5), Pair("wheelbase", 0.8),
                                     Pair("hitch_length", 0.8), Pair("max_speed", 2.5), Pair("min_speed", 0),
                                     Pair("max_steering", 1), Pair("max_acceleration", 5), Pair("max_steering_rate", 4),
                                     Pair("self_collision_gap", 2), Pair("max_hitch_angle", 1.5707963)));
    ASSERT_EQ(robot.bodies.size(), 16U);
    expect_box(robot.bodies[0], -0.35, 0.35, 0.25);
    expect_box(robot.bodies[15], -0.35, 0.35, 0.25);
  }
}

TEST(Robot, KinematicTruckHasTheDocumentedDefaults) {
  const RobotSpec robot = parse_robot("kinematic_truck:2");
  EXPECT_THAT(
      robot.parameters,
      UnorderedElementsAre(Pair("body_length", 0.7), Pair("body_width", 0.5), Pair("wheelbase", 0.8),
                           Pair("hitch_length", 0.8), Pair("max_speed", 2.5), Pair("min_speed", 0),
                           Pair("max_steering", 1), Pair("self_collision_gap", 2), Pair("max_hitch_angle", 1.5707963)));
  ASSERT_EQ(robot.bodies.size(), 3U);
  expect_box(robot.bodies[0], -0.35, 0.35, 0.25);
}

TEST(Robot, TheCarsBodyIsCentredOnTheMiddleOfTheWheelbase) {
  const RobotSpec car = parse_robot("car");
  ASSERT_EQ(car.bodies.size(), 1U);
  expect_box(car.bodies[0], 0.4 - 0.6, 0.4 + 0.6, 0.3);
}

TEST(Robot, UnicycleAndDiffDriveHaveTheDocumentedDefaults) {
  EXPECT_THAT(parse_robot("unicycle").parameters,
              UnorderedElementsAre(Pair("body_length", 0.5), Pair("body_width", 0.4), Pair("max_speed", 1),
                                   Pair("min_speed", -1), Pair("max_turn_rate", 2)));
  EXPECT_THAT(parse_robot("unicycle2").parameters,
              UnorderedElementsAre(Pair("body_length", 0.5), Pair("body_width", 0.4), Pair("max_speed", 1),
                                   Pair("min_speed", -1), Pair("max_turn_rate", 2), Pair("max_acceleration", 2),
                                   Pair("max_turn_acceleration", 4)));
  EXPECT_THAT(
      parse_robot("diff_drive").parameters,
      UnorderedElementsAre(Pair("body_length", 0.5), Pair("body_width", 0.4), Pair("wheel_radius", 0.08),
                           Pair("track_width", 0.36), Pair("max_wheel_speed", 12), Pair("max_wheel_acceleration", 24)));
  expect_box(parse_robot("unicycle").bodies[0], -0.25, 0.25, 0.2);
}

TEST(Robot, TheNumberOfTrailersIsFrom0To25) {
  EXPECT_EQ(parse_robot("snake:0").bodies.size(), 1U);
  EXPECT_EQ(parse_robot("truck:25").bodies.size(), 26U);
  for (const char* text :
       {"snake:26", "snake:-1", "snake:", "snake:2x", "snake:1e1", "snake: 3", "snake:99999999999"}) {
    EXPECT_THAT(parse_error(text), HasSubstr("must be from 0 to 25")) << text;
  }
  EXPECT_THAT(parse_error("snake"), HasSubstr("how many trailers"));
  EXPECT_THAT(parse_error("car:2"), HasSubstr("a car has no trailers"));
}

TEST(Robot, AnUnknownRobotIsToldTheKnownOnes) {
  EXPECT_THAT(parse_error("tank"), HasSubstr("known are snake:N and truck:N"));
  EXPECT_THAT(parse_error("none.json"), HasSubstr("none.json: cannot be read"));
  EXPECT_THAT(read_error(R"({"model": "tank"})"),
              HasSubstr("known are snake, truck, kinematic_truck, car, unicycle, unicycle2, diff_drive"));
  EXPECT_NE(error_of([] { default_parameters("tank"); }), "");
}

TEST(Robot, MissingParametersTakeDefaultsAndBodiesFollow) {
  const RobotSpec robot = read(R"({"model": "truck", "links": 2, "parameters": {"body_length": 2, "max_speed": 1}})");
  EXPECT_EQ(robot.parameters.at("max_speed"), 1);
  EXPECT_EQ(robot.parameters.at("wheelbase"), 0.8);
  ASSERT_EQ(robot.bodies.size(), 3U);
  expect_box(robot.bodies[2], -1, 1, 0.25);
}

TEST(Robot, ParametersOutOfRangeAreNamed) {
  const auto error = [](const std::string& parameter) {
    return read_error(R"({"model": "car", "parameters": {)" + parameter + "}}");
  };
  EXPECT_THAT(error(R"("max_steering": 1.5708)"),
              HasSubstr("parameters.max_steering: must be radians from 0.001 to 1.57, is 1.5708"));
  EXPECT_THAT(error(R"("max_steering": 1.5708)"), testing::Not(HasSubstr("degrees")));
  EXPECT_THAT(error(R"("max_steering": 30)"), HasSubstr("is 30; were degrees meant? 30 degrees are 0.5236 radians"));
  EXPECT_THAT(error(R"("max_speed": 1e9)"), testing::Not(HasSubstr("degrees")));
  EXPECT_THAT(error(R"("body_width": 0)"), HasSubstr("parameters.body_width"));
  EXPECT_THAT(error(R"("body_width": -1)"), HasSubstr("parameters.body_width"));
  EXPECT_THAT(error(R"("wheelbase": 1e300)"), HasSubstr("parameters.wheelbase"));
  EXPECT_THAT(error(R"("min_speed": 0.1)"), HasSubstr("parameters.min_speed"));
  EXPECT_THAT(error(R"("self_collision_gap": 2.5)"), HasSubstr("whole number"));
  EXPECT_THAT(error(R"("max_speed": null)"), HasSubstr("is null"));
  EXPECT_THAT(error(R"("wheelbase": "0.5")"),
              HasSubstr("parameters.wheelbase: must be metres from 0.001 to 1000, is \"0.5\""));
  EXPECT_THAT(error(R"("wheelbase": [1, 2])"), HasSubstr("is a list of 2"));
  EXPECT_THAT(read_error(R"({"model": "car", "parameters": 3})"),
              HasSubstr("parameters: must be an object of numbers by name, is 3"));
  EXPECT_THAT(error(R"("max_sped": 1)"), HasSubstr("unknown parameter \"max_sped\"; a car has body_length, "));
  EXPECT_EQ(error(R"("min_speed": -1)"), "");
}

TEST(Robot, AParameterBesideTheParametersIsToldItsPlace) {
  EXPECT_THAT(read_error(R"({"model": "car", "body_width": 1})"),
              HasSubstr("\"body_width\" is a parameter: it goes into \"parameters\": {\"body_width\": …}"));
  EXPECT_THAT(read_error(R"({"model": "car", "wheel_radius": 1})"), HasSubstr("\"wheel_radius\" is a parameter"));
  EXPECT_THAT(read_error(R"({"model": "car", "colour": 1})"), HasSubstr("unknown key \"colour\""));
}

TEST(Robot, OfAModelWithoutTrailersHasNoLinks) {
  EXPECT_THAT(read_error(R"({"model": "car", "links": 2})"), HasSubstr("links: a car has no trailers: leave it out"));
  EXPECT_THAT(read_error(R"({"model": "unicycle", "links": null})"), HasSubstr("links: a unicycle has no trailers"));
  EXPECT_EQ(read_error(R"({"model": "car", "links": 0})"), "");
}

TEST(Robot, AUnicyclesLeastSpeedIsAtMostItsTopSpeed) {
  const auto error = [](const std::string& speeds) {
    return read_error(R"({"model": "unicycle", "parameters": {)" + speeds + "}}");
  };
  EXPECT_EQ(error(R"("min_speed": 0.5, "max_speed": 0.5)"), "");
  EXPECT_THAT(error(R"("min_speed": 0.6, "max_speed": 0.5)"),
              HasSubstr("parameters: min_speed must be at most max_speed, which is 0.5"));
}

// As in the library.
TEST(Robot, HitchesFoldUpToPi) {
  const auto text = [](const char* angle) {
    return std::string(R"({"model": "truck", "links": 1, "parameters": {"max_hitch_angle": )") + angle + "}}";
  };
  EXPECT_EQ(read(text("3.1415926")).parameters.at("max_hitch_angle"), 3.1415926);
  EXPECT_THAT(read_error(text("3.1416")), HasSubstr("parameters.max_hitch_angle"));
}

TEST(Robot, GivenBodiesBecomeCounterClockwise) {
  const RobotSpec robot = read(R"({"model": "unicycle", "bodies": [{"polygon": [[0, 1], [1, 0], [0, -1], [-1, 0]]}]})");
  const Ring& ring = robot.bodies[0];
  EXPECT_EQ(ring[0].x, -1);
  EXPECT_EQ(ring[1].y, -1);
}

TEST(Robot, UnusableBodiesAreRefused) {
  const auto error = [](const std::string& polygon) {
    return read_error(R"({"model": "unicycle", "bodies": [{"polygon": )" + polygon + "}]}");
  };
  EXPECT_THAT(error("[[0,0],[2,0],[0.1,0.1],[0,2]]"), HasSubstr("bodies[0]: must be strictly convex"));
  EXPECT_THAT(error("[[0,0],[1,0],[2,0],[0,2]]"), HasSubstr("strictly convex"));
  EXPECT_THAT(error("[[0,0],[1,0],[1,0],[0,2]]"), HasSubstr("strictly convex"));
  EXPECT_THAT(error("[[0,1],[0.6,-0.8],[-0.95,0.3],[0.95,0.3],[-0.6,-0.8]]"), HasSubstr("strictly convex"));  // a star
  EXPECT_THAT(error("[[0,0],[1,0]]"), HasSubstr("at least 3"));
  EXPECT_THAT(error("[[0,0],[1,0],[2,1],[3,2],[3,3],[2,4],[1,5],[0,5],[-1,4]]"), HasSubstr("at most 8"));
  EXPECT_THAT(error("[[0,0],[1e9,0],[0,1]]"), HasSubstr("polygon[1][0]"));
  EXPECT_THAT(read_error(R"({"model": "snake", "links": 1, "bodies": []})"), HasSubstr("links + 1 = 2 bodies, has 0"));
}

TEST(Robot, UnknownKeysAndMissingLinksAreErrors) {
  EXPECT_THAT(read_error(R"({"model": "car", "parametres": {}})"), HasSubstr("unknown key \"parametres\""));
  EXPECT_THAT(read_error(R"({"model": "car", "parameters": {"le\nngth": 1}})"), HasSubstr("\"le\\u000Angth\""));
  EXPECT_THAT(read_error(R"({"model": "snake"})"), HasSubstr("links: is missing"));
}

TEST(Robot, JsonReadsBackTheSameRobot) {
  for (const std::string& text : every_robot(3)) {
    const RobotSpec robot = parse_robot(text);
    const RobotSpec copy = read(to_json(robot).dump());
    EXPECT_EQ(copy.model, robot.model);
    EXPECT_EQ(copy.links, robot.links);
    EXPECT_EQ(copy.parameters, robot.parameters);
    EXPECT_EQ(to_json(copy), to_json(robot));
  }
}

using RobotFile = ScratchTest;

TEST_F(RobotFile, IsReadByItsPath) {
  EXPECT_EQ(parse_robot(write("r.json", R"({"model": "snake", "links": 4})")).links, 4);
  EXPECT_THAT(parse_error(write("bad.json", "{")), HasSubstr("is not valid JSON"));
}

}  // namespace
}  // namespace krait::host::host_robot_test
