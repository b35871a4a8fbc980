// SPDX-License-Identifier: GPL-3.0-or-later
// Whether robots park, and leave where they are parked: parking [SEEDS]. Forty bays beside an aisle, between other
// vehicles and opposite to clutter, are 1.2 to 1.6 times as long as a passenger car that stands parallel to the aisle,
// or as wide as a vehicle that backs in, or backs out.
// Prints for each vehicle how many searches were solved, and their vertices; every plan is judged by the verifier.
// Exits 1 when a plan does not hold, a search is in vain, or the median costs more vertices than allowed.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "../plans/options.hpp"
#include "host/compiler/compiler.hpp"
#include "host/run/session.hpp"

namespace krait::host {
namespace {

constexpr int kBays = 40;
constexpr std::uint64_t kIterations = 20'000;  // of a search
constexpr std::uint64_t kMemory = 8U << 20U;   // bytes

struct Task {
  const char* robot;
  const char* name;
  bool parallel;       // to the aisle; else at right angles, with the front toward it,
  bool leaves;         // or, where the robot begins in the bay and leaves it, away from it
  std::uint64_t most;  // vertices of a search, in the median
};

constexpr Task kTasks[] = {
    {"nissan_leaf", "parallel", true, false, 1'500},    {"nissan_leaf", "backing in", false, false, 8'000},
    {"fork_lift", "backing in", false, false, 1'500},   {"nissan_leaf", "leaving", true, true, 2'500},
    {"nissan_leaf", "backing out", false, true, 2'500}, {"fork_lift", "backing out", false, true, 1'500}};

// The box of body 0.
struct Vehicle {
  double back, front, width;
  double length() const { return front - back; }
};

Vehicle vehicle_of(const RobotSpec& robot) {
  Vehicle vehicle{0, 0, 0};
  for (const Point& corner : robot.bodies.front()) {
    vehicle.back = std::min(vehicle.back, corner.x);
    vehicle.front = std::max(vehicle.front, corner.x);
    vehicle.width = std::max(vehicle.width, 2 * corner.y);
  }
  return vehicle;
}

// An aisle along x with a row of vehicles on its left side, one of which is missing, and clutter on its right.
struct Bay {
  Workspace workspace;
  SearchRequest request;

  void block(double x0, double y0, double x1, double y1) {
    const double low = std::min(x0, x1);
    const double high = std::max(x0, x1);
    workspace.obstacles.push_back({"", {{low, y0}, {high, y0}, {high, y1}, {low, y1}}, {}});
  }
};

Bay make_bay(const Task& task, int number) {
  std::mt19937_64 random(static_cast<std::uint64_t>(number));
  const auto draw = [&](double low, double high) {  // the standard library's distributions differ between machines
    return low + (high - low) * static_cast<double>(random() >> 11U) / 9007199254740992.0;
  };
  Bay bay;
  bay.request.robot = parse_robot(task.robot);
  const Vehicle vehicle = vehicle_of(bay.request.robot);
  const double share = 1.2 + 0.4 * number / (kBays - 1);
  const double along = task.parallel ? vehicle.length() : vehicle.width;  // of a vehicle in the row
  const double across = task.parallel ? vehicle.width : vehicle.length();
  const double aisle = (task.parallel ? 1.35 : 1.5) * vehicle.length();
  const double end = aisle + (task.parallel ? 1.25 : 1.15) * across;
  const double length = 9 * vehicle.length();
  const double middle = 5 * vehicle.length();
  bay.workspace.name = "bay" + std::to_string(number);
  bay.workspace.max = {length, end};
  for (const double side : {-1.0, 1.0}) {
    for (double x = middle + side * share * along / 2; x > 0 && x < length;) {
      const double next = x + side * along * draw(0.9, 1.1);
      bay.block(x, end - across * draw(1.0, 1.15), next, end);
      x = next + side * along * draw(0.1, 0.6);
    }
  }
  for (int i = 0; i < 6; ++i) {
    const double x = draw(0, length);
    bay.block(x, 0, x + vehicle.length() * draw(0.2, 0.6), vehicle.width * draw(0.1, 0.25));
  }
  const double across_aisle = (task.leaves ? 1 : -1) * std::numbers::pi / 2;
  const double heading = task.parallel ? 0 : across_aisle;
  const double center = (vehicle.front + vehicle.back) / 2;
  const double row = (aisle + end) / 2;
  const Point parked{middle - center * std::cos(heading), row - center * std::sin(heading)};
  const double gap = 0.3 * vehicle.length();  // at the ends of the aisle
  if (task.leaves) {
    bay.request.start = StartPose{parked, heading};
    bay.request.goal = GoalDisc{{length - gap - vehicle.front, aisle / 2}, 0.3 * vehicle.width};
  } else {
    bay.request.start = StartPose{{gap - vehicle.back, aisle / 2}, 0};
    bay.request.goal = GoalDisc{parked, 0.1};
    bay.request.facing = GoalFacing{heading, 0.1, false, {}};
  }
  bay.request.iterations = kIterations;
  bay.request.memory = kMemory;
  return bay;
}

bool park(const Task& task, std::uint64_t seeds) {
  static Block block;
  std::vector<std::uint64_t> vertices;
  std::uint64_t solved = 0;
  for (int number = 0; number < kBays; ++number) {
    Bay bay = make_bay(task, number);
    const CompiledScene scene = compile(bay.workspace, {});
    const SceneBytes bytes = SceneBytes::copy(scene.bytes.data(), scene.bytes.size());
    if (block.empty()) block = block_of(bay.request);
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      bay.request.seed = seed;
      const SearchResult result = run_search("bay", bytes, bay.request, block, {});
      vertices.push_back(result.plan.statistics->at("vertices").get<std::uint64_t>());
      if (result.plan.status == "solved" && verify(bay.workspace, result.plan, result.asked).holds) {
        ++solved;
        continue;
      }
      std::printf("%s, %s, bay %d, seed %d: %s\n", task.robot, task.name, number, static_cast<int>(seed),
                  result.plan.status.c_str());
    }
  }
  std::sort(vertices.begin(), vertices.end());
  const std::uint64_t median = vertices[vertices.size() / 2];
  std::printf("%s, %s: %d of %d, vertices %d [%d]\n", task.robot, task.name, static_cast<int>(solved),
              static_cast<int>(vertices.size()), static_cast<int>(median),
              static_cast<int>(vertices[vertices.size() * 9 / 10]));
  return solved == vertices.size() && median <= task.most;
}

}  // namespace
}  // namespace krait::host

int main(int argc, char** argv) {
  using namespace krait::host;
  const std::uint64_t seeds = argc > 1 ? test::number_or_exit(argv[1], 1, "the number of seeds") : 2;
  bool all = true;
  for (const Task& task : kTasks) all = park(task, seeds) && all;
  return all ? 0 : 1;
}
