// SPDX-License-Identifier: Apache-2.0
// Every shipped robot plans in `openings`, drawn at its own size, and its plans hold.
#include "host/cli/campaign.hpp"
#include "host/cli/program.hpp"
#include "host/robot_file/shipped.hpp"
#include "host/run/robot_facts.hpp"
#include "host/scenes/scenes.hpp"

namespace krait::host {
namespace {

// Every length of a scene in JSON, times `by`.
void scale(nlohmann::json& value, double by) {
  for (auto& [key, item] : value.items()) {
    if (key == "angle" || key == "heading" || key == "angles") continue;
    if (item.is_number()) {
      item = item.get<double>() * by;
    } else if (item.is_structured()) {
      scale(item, by);
    }
  }
}

// So that passages of 1.4 m have the room that the default car has there.
double size_of(const RobotSpec& robot) {
  const RobotFacts facts = facts_of("shipped", robot, Parameters());
  double half_width = 0;
  for (const Point& corner : robot.bodies[0]) half_width = std::max(half_width, std::abs(corner.y));
  return std::max(facts.tightest.outer / 1.3, half_width / 0.35);
}

class ShippedRobotPlans : public ScratchTest, public testing::WithParamInterface<std::string> {};

TEST_P(ShippedRobotPlans, InOpenings) {
  Query query;
  query.robot = parse_robot(GetParam());
  nlohmann::json scene = nlohmann::json::parse(scene_json("openings", 1));
  scale(scene, size_of(query.robot));
  query.input = write("scene.json", scene.dump());
  query.compiled = path("scene.krait");
  ASSERT_NO_FATAL_FAILURE(compile_input(query, directory()));
  expect_all_solved("openings, " + GetParam(), query, seeds(3, 30));
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const ShippedRobot& shipped : shipped_robots()) all.push_back(shipped.name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedRobotPlans, testing::ValuesIn(names()),
                         [](const auto& robot) { return robot.param; });

}  // namespace
}  // namespace krait::host
