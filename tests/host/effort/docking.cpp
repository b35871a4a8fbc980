// SPDX-License-Identifier: GPL-3.0-or-later
// Whether trucks dock: docking [SEEDS]. Forty docks in a yard with clutter, between vehicles that stand as deep as some
// of the truck's trailers, are 1.2 to 1.6 times as wide as the truck, which starts anywhere in any direction. Every
// fourth of them is tried, or with KRAIT_LONG_TESTS=1 all. Prints for each truck how many searches were solved, and
// their vertices; every plan is judged by the verifier. Exits 1 when a plan does not hold, fewer searches than asked
// are solved, or the median costs more vertices than allowed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "../../long_tests.hpp"
#include "../plans/options.hpp"
#include "host/compiler/compiler.hpp"
#include "host/run/session.hpp"

namespace krait::host {
namespace {

constexpr int kDocks = 40;
constexpr std::uint64_t kIterations = 20'000;  // of a search
constexpr std::uint64_t kMemory = 32U << 20U;  // bytes

struct Task {
  const char* robot;
  double min_speed;     // m/s
  double deep;          // hitch lengths: of the dock
  double radius;        // metres: of the goal
  std::uint64_t least;  // of a hundred searches, that are solved
  std::uint64_t most;   // vertices of a search, in the median
};

constexpr Task kTasks[] = {
    {"truck:1", -1, 2, 0.1, 100, 3'000},           {"truck:2", -1, 3, 0.1, 80, 200'000},
    {"truck:3", -1, 1, 0.1, 30, 1'000'000},        {"kinematic_truck:1", -1, 2, 0.1, 100, 3'000},
    {"kinematic_truck:2", -1, 3, 0.1, 90, 30'000}, {"kinematic_truck:3", -1, 1, 0.1, 80, 500'000},
    {"semitrailer", -1.5, 1.2, 0.3, 95, 50'000},   {"b_double", -1.5, 1.2, 0.3, 70, 500'000},
};

struct Train {
  int trailers;
  double hitch, width;
  double tail;  // metres from the last axle to the last body's end
};

Train train_of(const RobotSpec& robot) {
  Train train{robot.links, robot.parameters.at("hitch_length"), 0, 0};
  for (const Ring& body : robot.bodies) {
    for (const Point& corner : body) train.width = std::max(train.width, 2 * corner.y);
  }
  for (const Point& corner : robot.bodies.back()) train.tail = std::max(train.tail, -corner.x);
  return train;
}

struct Yard {
  Workspace workspace;
  SearchRequest request;

  void block(double x0, double y0, double x1, double y1) {
    workspace.obstacles.push_back({"", {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}});
  }
};

Yard make_yard(const Task& task, int number) {
  std::mt19937_64 random(static_cast<std::uint64_t>(number));
  const auto draw = [&](double low, double high) {  // the standard library's distributions differ between machines
    return low + (high - low) * static_cast<double>(random() >> 11U) / 9007199254740992.0;
  };
  Yard yard;
  yard.request.robot = parse_robot(task.robot);
  yard.request.robot.parameters["min_speed"] = task.min_speed;
  const Train train = train_of(yard.request.robot);
  const double d = train.hitch;
  const double whole = train.trailers * d;
  yard.workspace.name = "yard" + std::to_string(number);
  yard.workspace.max = {24 * d, 16 * d + 2 * whole};
  const double middle = draw(8, 16) * d;
  const double half = (1.2 + 0.4 * number / (kDocks - 1)) * train.width / 2;
  const double depth = task.deep * d + train.tail;
  yard.block(middle - half - train.width, 0, middle - half, depth);
  yard.block(middle + half, 0, middle + half + train.width, depth);
  const Point goal{middle, 1.1 * train.tail + 0.1 * d + whole};
  const Point start{draw(4, 20) * d, draw(9, 11) * d + whole};
  for (int placed = 0; placed < 6;) {
    const double x = draw(1, 23) * d;
    const double y = draw(2, 13) * d + whole;
    const double size = draw(0.2, 0.6) * d;
    if (std::hypot(x - start.x, y - start.y) < whole + 2 * d || std::hypot(x - goal.x, y - goal.y) < whole + 3 * d) {
      continue;
    }
    yard.block(x - size, y - size, x + size, y + size);
    ++placed;
  }
  yard.request.goal = GoalDisc{goal, task.radius};
  yard.request.facing = GoalFacing{std::numbers::pi / 2, 0.1, false, 0.2};
  yard.request.start = StartPose{start, draw(-3, 3)};
  yard.request.iterations = kIterations;
  yard.request.memory = kMemory;
  return yard;
}

bool dock(const Task& task, std::uint64_t seeds) {
  static Block block;
  std::vector<std::uint64_t> vertices;
  std::uint64_t solved = 0;
  bool holds = true;
  const int step = static_cast<int>(krait::test::by_length(4, 1));
  for (int number = step / 2; number < kDocks; number += step) {
    Yard yard = make_yard(task, number);
    const CompiledScene scene = compile(yard.workspace, {});
    const SceneBytes bytes = SceneBytes::copy(scene.bytes.data(), scene.bytes.size());
    if (block.empty()) block = block_of(yard.request);
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      yard.request.seed = seed;
      const SearchResult result = run_search("yard", bytes, yard.request, block, {});
      vertices.push_back(result.plan.statistics->at("vertices").get<std::uint64_t>());
      if (result.plan.status != "solved") continue;
      ++solved;
      if (verify(yard.workspace, result.plan, result.asked).holds) continue;
      holds = false;
      std::printf("%s, dock %d, seed %d: the plan does not hold\n", task.robot, number, static_cast<int>(seed));
    }
  }
  std::sort(vertices.begin(), vertices.end());
  const std::uint64_t median = vertices[vertices.size() / 2];
  std::printf("%s, %.1f hitch lengths deep: %d of %d, vertices %d [%d]\n", task.robot, task.deep,
              static_cast<int>(solved), static_cast<int>(vertices.size()), static_cast<int>(median),
              static_cast<int>(vertices[vertices.size() * 9 / 10]));
  return holds && 100 * solved >= task.least * vertices.size() && median <= task.most;
}

}  // namespace
}  // namespace krait::host

int main(int argc, char** argv) {
  using namespace krait::host;
  const std::uint64_t seeds = argc > 1 ? test::number_or_exit(argv[1], 1, "the number of seeds") : 1;
  bool all = true;
  for (const Task& task : kTasks) all = dock(task, seeds) && all;
  return all ? 0 : 1;
}
