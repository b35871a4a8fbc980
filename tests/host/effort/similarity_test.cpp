// SPDX-License-Identifier: GPL-3.0-or-later
// Planning knows no metre: a scene, a robot and its speeds that are a quarter, four times and sixteen times as large
// cost as many vertices. Sixteen times, or with KRAIT_LONG_TESTS=1 all three.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "../../long_tests.hpp"
#include "../every_robot.hpp"
#include "host/compiler/compiler.hpp"
#include "host/run/session.hpp"
#include "host/scenes/scenes.hpp"

namespace krait::host {
namespace {

constexpr std::uint64_t kSeeds = 1000;  // of fewer, medians are a tenth apart by chance

void scale(Ring& ring, double by) {
  for (Point& p : ring) p = {p.x * by, p.y * by};
}

Workspace scaled(Workspace workspace, double by) {
  workspace.min = {workspace.min.x * by, workspace.min.y * by};
  workspace.max = {workspace.max.x * by, workspace.max.y * by};
  for (Obstacle& obstacle : workspace.obstacles) {
    scale(obstacle.outer, by);
    for (Ring& hole : obstacle.holes) scale(hole, by);
  }
  for (Goal& goal : workspace.goals) scale(goal.polygon, by);
  for (Start& start : workspace.starts) start.position = {start.position.x * by, start.position.y * by};
  return workspace;
}

// Lengths, speeds and accelerations; a wheel's angles and times stay. Bodies are a quarter larger, since those of
// the models just go through the scenes' narrow gaps or just not: there the scene's grid of half a millimetre decides.
RobotSpec scaled(RobotSpec robot, double by) {
  for (auto& [name, value] : robot.parameters) {
    if (unit_of(robot.model, name).starts_with("metres")) value *= by;
  }
  for (Ring& body : robot.bodies) scale(body, 1.25 * by);
  return robot;
}

// The median of the vertices of searches that all end in a plan.
double median_vertices(const std::string& scene, const std::string& robot, double by) {
  const CompiledScene compiled = compile(scaled(make_scene(scene, 1).workspace, by), {});
  const SceneBytes bytes = SceneBytes::copy(compiled.bytes.data(), compiled.bytes.size());
  SearchRequest request;
  request.robot = scaled(parse_robot(robot), by);
  request.parameters.clearance *= static_cast<float>(by);
  request.memory = 8U << 20U;
  Block block = block_of(request);
  std::vector<double> vertices;
  for (request.seed = 1; request.seed <= kSeeds; ++request.seed) {
    const SearchResult result = run_search("scene", bytes, request, block, {});
    EXPECT_EQ(result.plan.status, "solved") << scene << ' ' << robot << " times " << by << ", seed " << request.seed;
    vertices.push_back(result.plan.statistics->at("vertices").get<double>());
  }
  std::nth_element(vertices.begin(), vertices.begin() + kSeeds / 2, vertices.end());
  return vertices[kSeeds / 2];
}

class Similarity : public ::testing::TestWithParam<std::string> {};

TEST_P(Similarity, SearchesCostTheSameAtEverySize) {
  const double vertices = median_vertices("rooms", GetParam(), 1);
  const double scales[] = {16, 0.25, 4};
  for (const double by : std::span(scales).first(krait::test::by_length(1, 3))) {
    EXPECT_NEAR(median_vertices("rooms", GetParam(), by), vertices, 0.1 * vertices) << "times " << by;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Similarity, ::testing::ValuesIn(every_robot(3)), [](const auto& robot) {
  std::string name = robot.param;
  std::replace(name.begin(), name.end(), ':', '_');
  return name;
});

}  // namespace
}  // namespace krait::host
