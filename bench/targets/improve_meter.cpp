// SPDX-License-Identifier: Apache-2.0
// What an iteration of improving a plan costs in instructions, in a block that the smallest boards have. Over all
// scenes that lie on the board, ten seeds each. Prints one line of JSON a robot.
#include <algorithm>
#include <optional>

#include "firmware/application.hpp"
#include "firmware/improvement.hpp"
#include "firmware/line.hpp"
#include "firmware/scene_pack.hpp"
#include "instructions.hpp"
#include "krait/robots/detail/defaults.hpp"
#include "quantile.hpp"

namespace krait::bench {
namespace {

using firmware::Board;

constexpr std::uint64_t kBlock = 96 * 1024;
constexpr std::uint64_t kSeeds = 10;
constexpr double kMultiples = 10;  // as krait plan improves

struct Costs {
  std::uint64_t searches = 0;
  std::uint64_t solved = 0;
  std::uint64_t steps = 0;        // of all plans, and
  std::uint64_t best = 0;         // when they were improved
  std::uint64_t search = 0;       // instructions until those were found, and
  std::uint64_t improve = 0;      // of improving them
  std::uint64_t start = 0;        // the most expensive start: it holds a Dijkstra
  std::uint64_t placement = 0;    // the most expensive of an iteration's placements on average, all in
  std::uint64_t first_worst = 0;  // the most expensive first iteration: it holds a Dijkstra
  Median<6> iteration;            // the others
};

// Improves a plan that was found.
void improve(const Board& board, Planner& planner, Costs& costs) {
  std::uint64_t placements = planner.statistics().collision_checks;
  bool first = true;
  costs.steps += planner.statistics().plan_steps;
  firmware::improve(planner, kMultiples, [&] {
    const std::uint64_t begin = instructions(board);
    const bool goes_on = planner.improve(1) == Status::solved;
    const std::uint64_t cost = instructions(board) - begin;
    const std::uint64_t placed = planner.statistics().collision_checks - placements;
    costs.improve += cost;
    if (first) {
      costs.first_worst = std::max(costs.first_worst, cost);
    } else {
      costs.iteration.add(static_cast<std::uint32_t>(cost));
    }
    first = false;
    if (placed > 0) costs.placement = std::max(costs.placement, cost / placed);
    placements += placed;
    return goes_on;
  });
  costs.best += planner.statistics().plan_steps;
}

void improve_everywhere(const Board& board, const Robot& robot, Costs& costs) {
  static Planner planner;
  firmware::for_each_scene(board, [&](const Scene& scene) {
    float start[kMaxState];
    const ScenePose pose = scene.start(0);
    (void)robot.rest(pose.position, pose.heading, pose.angles, pose.angle_count, start);
    (void)firmware::init_with_room(planner, {board.arena, kBlock, &scene, robot}, {}, 20000, kMultiples);
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const std::uint64_t begin = instructions(board);
      (void)planner.start({start, Goal::named(0), seed});
      costs.start = std::max(costs.start, instructions(board) - begin);
      while (planner.status() == Status::searching) (void)planner.advance(1);
      costs.search += instructions(board) - begin;
      ++costs.searches;
      if (planner.status() != Status::solved) continue;
      ++costs.solved;
      improve(board, planner, costs);
    }
  });
}

void measure(const Board& board, const char* name, const Robot& robot) {
  static std::optional<Costs> made;  // large for a small stack, as is the line
  Costs& costs = made.emplace();
  improve_everywhere(board, robot, costs);
  static std::optional<firmware::JsonLine> line;
  line.emplace()
      .add("machine", board.name)
      .add("robot", name)
      .add("block", kBlock)
      .add("searches", costs.searches)
      .add("solved", costs.solved)
      .add("steps_first", costs.steps)
      .add("steps_best", costs.best)
      .add("search", costs.search)
      .add("improve", costs.improve)
      .add("iterations", costs.iteration.count())
      .add("iteration_median", std::uint64_t{costs.iteration.median()})
      .add("iteration_worst", std::uint64_t{costs.iteration.worst()})
      .add("first_worst", costs.first_worst)
      .add("start_worst", costs.start)
      .add("placement_worst", costs.placement);
  board.port.log(board.port.context, line->end());
}

template <class R>
R with_trailers(int trailers) {
  auto parameters = defaults_of<R>();
  parameters.trailers = trailers;
  return R(parameters);
}

}  // namespace
}  // namespace krait::bench

namespace krait::firmware {

int run(const Board& board, int, const char* const*) {
  static const Car car(defaults_of<Car>());
  static const Truck truck = bench::with_trailers<Truck>(2);
  static const DifferentialDrive drive(defaults_of<DifferentialDrive>());
  static const Snake snake = bench::with_trailers<Snake>(5);
  bench::measure(board, "car", Robot(car));
  bench::measure(board, "truck:2", Robot(truck));
  bench::measure(board, "diff_drive", Robot(drive));
  bench::measure(board, "snake:5", Robot(snake));
  return kDone;
}

}  // namespace krait::firmware
