// SPDX-License-Identifier: Apache-2.0
// Builds and runs the programs of README.md and USING.md.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

#include "krait/krait.hpp"
#include "krait/robot_check.hpp"
#include "paths.hpp"
#include "readme_program.inc"
#include "readme_robot.inc"

namespace {

struct SceneFile {
  std::vector<std::uint64_t> words;
  std::size_t size = 0;
};

SceneFile compiled(const std::string& scene) {
  const std::filesystem::path base = std::filesystem::path(testing::TempDir()) / ("readme_" + scene);
  const std::string program = krait::test::program_path("krait");
  const std::string command = program + " scene " + scene + " -o " + base.string() + ".json && " + program +
                              " compile " + base.string() + ".json -o " + base.string() + ".krait";
  if (std::system(command.c_str()) != 0) throw std::runtime_error("cannot run: " + command);
  std::ifstream file(base.string() + ".krait", std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  SceneFile result{std::vector<std::uint64_t>((bytes.size() + 7) / 8), bytes.size()};
  std::memcpy(result.words.data(), bytes.data(), bytes.size());
  return result;
}

TEST(Readme, ProgramDrivesATruckThroughAShippedScene) {
  const SceneFile scene = compiled("corridors");
  EXPECT_EQ(drive(scene.words.data(), scene.size), 0);
}

TEST(Readme, ProgramRefusesBytesThatAreNoScene) {
  SceneFile scene = compiled("corridors");
  scene.words[10] ^= 1U;
  EXPECT_EQ(drive(scene.words.data(), scene.size), 2);
}

TEST(Readme, OwnRobotKeepsItsPromises) {
#include "readme_check.inc"
  EXPECT_TRUE(report.ok()) << report.text();
  EXPECT_EQ(report.samples, 1000);
}

TEST(Readme, OwnRobotPlans) {
  static_assert(krait::RobotModel<Hoverer>);
  const SceneFile bytes = compiled("openings");
  krait::Scene scene;
  ASSERT_TRUE(krait::Scene::open(bytes.words.data(), bytes.size, scene).ok());
  const Hoverer robot;
  std::vector<std::uint64_t> memory(1U << 20U);
  const auto planner = std::make_unique<krait::Planner>();
  const std::size_t size = memory.size() * sizeof memory[0];
  ASSERT_TRUE(planner->init({memory.data(), size, &scene, robot}).ok());
  const krait::Vec2 at = scene.start(0).position;
  const float start[] = {at.x, at.y, 0.0F, 0.0F};
  EXPECT_EQ(planner->start({start, krait::Goal::named(0), 1}), krait::Status::searching);
  ASSERT_EQ(planner->advance(100000), krait::Status::solved);
  krait::PlanCursor end = planner->plan().cursor();
  while (!end.done()) end.advance();
  EXPECT_TRUE(krait::Goal::named(0).contains(scene, {end.state()[0], end.state()[1]}, 0.0F));
}

}  // namespace
