// SPDX-License-Identifier: Apache-2.0
// Plans that are improved: the counts and the best plan after every iteration.
#include "krait/krait.hpp"
#include "stages.hpp"

namespace krait::stages {
namespace {

constexpr std::uint64_t kBlock = 256 * 1024;
constexpr Limits kLimits{.iterations = 500, .way_legs = 128};
constexpr int kIterations = 64;

void improve(const firmware::Board& board, const Scene& scene, const char* name, const Robot& robot) {
  static Planner planner;
  Hash hash;
  float start[kMaxState];
  const ScenePose pose = scene.start(0);
  (void)robot.rest(pose.position, pose.heading, pose.angles, pose.angle_count, start);
  const bool ready = planner.init({board.arena, kBlock, &scene, robot}, {}, kLimits).ok();
  hash.add(std::uint32_t{ready});
  (void)planner.start({start, Goal::named(0), 1});
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
  report(board, {scene.name(), name, "improved"}, hash);
}

}  // namespace

void improvements(const firmware::Board& board, const Scene& scene) {
  for_each_robot([&](const char* name, const auto& robot) { improve(board, scene, name, Robot(robot)); });
}

}  // namespace krait::stages
