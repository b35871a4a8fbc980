// SPDX-License-Identifier: Apache-2.0
// What planning costs on a machine, in instructions: a step of Runge-Kutta, a vertex, a call of advance(1). Over all
// scenes that lie on the board, two seeds each. Prints one line of JSON.
#include <algorithm>

#include "firmware/application.hpp"
#include "firmware/line.hpp"
#include "firmware/scene_pack.hpp"
#include "instructions.hpp"
#include "quantile.hpp"
#include "search/adaptive_search.hpp"

namespace krait::bench {
namespace {

using firmware::Board;
using firmware::Request;

constexpr std::uint64_t kBlock = 416 * 1024;
constexpr std::uint64_t kSeeds = 10;
constexpr std::uint32_t kSteps = 256;

struct Costs {
  std::uint64_t runge_kutta = 0;
  Median<8> vertex;
  Median<8> advance;       // the calls that leave the search going on
  std::uint64_t last = 0;  // the most expensive call that ended one: it replays the plan
  std::uint64_t searches = 0;
  std::uint64_t solved = 0;
  std::uint64_t vertices = 0;
  std::uint64_t search = 0;     // instructions of all calls of advance
  std::uint64_t start = 0;      // the most expensive start: it holds a Dijkstra
  std::uint64_t placement = 0;  // the most expensive of an expansion's placements on average, all in but a Dijkstra
};

std::uint64_t runge_kutta(const Board& board, const Robot& robot) {
  float states[2][kMaxState] = {};
  const float control[kMaxControl] = {0.5F, 0.1F};
  const std::uint64_t begin = instructions(board);
  for (std::uint32_t i = 0; i < kSteps; ++i) detail::propagate(robot, states[i % 2], control, 0.01F, states[1 - i % 2]);
  return (instructions(board) - begin) / kSteps;
}

// One call of advance(1).
std::uint64_t expand(const Board& board, Planner& planner, Costs& costs) {
  const Statistics before = planner.statistics();
  const std::uint64_t begin = instructions(board);
  (void)planner.advance(1);
  const std::uint64_t cost = instructions(board) - begin;
  const Statistics after = planner.statistics();
  costs.search += cost;
  if (planner.status() != Status::searching) {
    costs.last = std::max(costs.last, cost);
    return cost;
  }
  costs.advance.add(static_cast<std::uint32_t>(cost));
  const std::uint64_t placements = after.collision_checks - before.collision_checks;
  if (after.dijkstra_runs == before.dijkstra_runs && placements > 0) {
    costs.placement = std::max(costs.placement, cost / placements);
  }
  return cost;
}

// One search. A vertex costs its share of its expansion and of those before it that made none.
void search(const Board& board, Planner& planner, Costs& costs) {
  std::uint64_t unshared = 0;
  while (planner.status() == Status::searching) {
    const std::uint64_t vertices = planner.statistics().vertices;
    unshared += expand(board, planner, costs);
    const auto made = static_cast<std::uint32_t>(planner.statistics().vertices - vertices);
    costs.vertices += made;
    if (made == 0) continue;
    costs.vertex.add(static_cast<std::uint32_t>(unshared / made), made);
    unshared = 0;
  }
}

void search_everywhere(const Board& board, const Robot& robot, Costs& costs) {
  static Planner planner;
  firmware::for_each_scene(board, [&](const Scene& scene) {
    float start[kMaxState];
    const ScenePose pose = scene.start(0);
    (void)robot.rest(pose.position, pose.heading, pose.angles, pose.angle_count, start);
    (void)planner.init({board.arena, kBlock, &scene, robot});
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const std::uint64_t begin = instructions(board);
      (void)planner.start({start, Goal::named(0), seed});
      costs.start = std::max(costs.start, instructions(board) - begin);
      search(board, planner, costs);
      ++costs.searches;
      if (planner.status() == Status::solved) ++costs.solved;
    }
  });
}

// Bytes by pool for the first scene, when the block is `block` bytes.
void add_pools(firmware::JsonLine& line, const Board& board, const Robot& robot, std::uint64_t block) {
  static Planner planner;
  bool first = true;
  firmware::for_each_scene(board, [&](const Scene& scene) {
    if (!first) return;
    first = false;
    (void)planner.init({board.arena, block, &scene, robot});
    for (std::size_t pool = 0; pool < detail::kPoolCount; ++pool) {
      const std::uint64_t bytes = detail::opened(planner).arena().needed(static_cast<detail::Pool>(pool));
      if (bytes > 0) line.add(to_string(static_cast<detail::Pool>(pool)), bytes);
    }
  });
}

int measure(const Board& board, const Request& request) {
  ChainParameters parameters;
  parameters.trailers = request.trailers;
  static const Snake snake(parameters);
  const Robot robot(snake);
  static Costs costs;
  costs.runge_kutta = runge_kutta(board, robot);
  search_everywhere(board, robot, costs);

  static firmware::JsonLine line;
  line.add("machine", board.name)
      .add("robot", request.robot)
      .add("searches", costs.searches)
      .add("solved", costs.solved)
      .add("vertices", costs.vertices)
      .add("search", costs.search)
      .add("start_worst", costs.start)
      .add("placement_worst", costs.placement)
      .add("rk4", costs.runge_kutta)
      .add("vertex_median", std::uint64_t{costs.vertex.median()})
      .add("vertex_worst", std::uint64_t{costs.vertex.worst()})
      .add("last_worst", costs.last)
      .add("advance_median", std::uint64_t{costs.advance.median()})
      .add("advance_worst", std::uint64_t{costs.advance.worst()});
  board.port.log(board.port.context, line.end());
  static firmware::JsonLine pools;
  add_pools(pools, board, robot, request.memory > 0 ? request.memory : kBlock);
  board.port.log(board.port.context, pools.end());
  return firmware::kDone;
}

}  // namespace
}  // namespace krait::bench

namespace krait::firmware {

int run(const Board& board, int count, const char* const* words) {
  Request request;
  const char* const complaint = parse(count, words, "snake", true, request);
  if (complaint != nullptr) {
    board.port.log(board.port.context, complaint);
    return kBadInput;
  }
  return bench::measure(board, request);
}

}  // namespace krait::firmware
