// SPDX-License-Identifier: Apache-2.0
// Plans that are improved, to a goal and to a pose: the counts and the best plan after every iteration.
#include "krait/krait.hpp"
#include "stages.hpp"

namespace krait::stages {
namespace {

constexpr std::uint64_t kBlock = 256 * 1024;
constexpr Limits kLimits{.iterations = 500, .way_legs = 128};
constexpr int kIterations = 64;

// Which goal it is, by its name.
struct Wanted {
  const char* name;
  Goal goal;
};

void improve(const firmware::Board& board, const Scene& scene, const char* name, const Robot& robot,
             const Wanted& wanted) {
  static Planner planner;
  Hash hash;
  float start[kMaxState];
  const ScenePose pose = scene.start(0);
  (void)robot.rest(pose.position, pose.heading, pose.angles, pose.angle_count, start);
  const bool ready = planner.init({board.arena, kBlock, &scene, robot}, {}, kLimits).ok();
  hash.add(std::uint32_t{ready});
  (void)planner.start({start, wanted.goal, 1});
  (void)planner.advance(kLimits.iterations + 1);
  for (int i = 0; i < kIterations && planner.improve(1) == Status::solved; ++i) {
    const Statistics statistics = planner.statistics();
    hash.add(statistics.iterations);
    hash.add(statistics.collision_checks);
    hash.add(statistics.dijkstra_runs);
    hash.add(statistics.improvements);
    hash.add(statistics.hash);
    hash.add(statistics.plan_length);
  }
  report(board, {scene.name(), name, wanted.name}, hash);
}

}  // namespace

void improvements(const firmware::Board& board, const Scene& scene) {
  const ScenePose start = scene.start(0);
  const Facing aside{start.heading + 0.5F * kPi, 0.1F, false, kInfinity};
  const Wanted goals[] = {{"improved", Goal::named(0)}, {"improved/pose", Goal::pose(start.position, 0.1F, aside)}};
  for_each_robot([&](const char* name, const auto& robot) {
    for (const Wanted& wanted : goals) improve(board, scene, name, Robot(robot), wanted);
  });
}

}  // namespace krait::stages
