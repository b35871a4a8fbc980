// SPDX-License-Identifier: Apache-2.0
// The application: opens the scene in place, plans, reports. One model of robot a program.
#pragma once

#include "firmware/board.hpp"
#include "firmware/report.hpp"
#include "firmware/request.hpp"
#include "krait/krait.hpp"

namespace krait::firmware {

// What models/MODEL.cpp gives: the model's name, whether it has trailers, and its planner.
extern const char* const kModel;
extern const bool kHasTrailers;
void plan(const Board& board, const Request& request, Report& report);

// Everything, from the command line's words (the program's name not among them) to the exit code.
int run(const Board& board, int count, const char* const* words);

// Views the scene that lies on the board. Its header says how long it is; bytes that are none are refused.
Failure open_scene(const Board& board, Scene& scene);

// The planner's block that is asked for, in bytes; at most what the board has unless more is asked for.
std::uint64_t block_bytes(const Board& board, const Request& request);

// Nanoseconds since it was made or last asked.
class Stopwatch {
 public:
  explicit Stopwatch(const Port& port) : port_(port), last_(now()) {}

  std::uint64_t lap() {
    const std::uint64_t before = last_;
    last_ = now();
    return last_ - before;
  }

 private:
  std::uint64_t now() const { return port_.clock(port_.context); }

  const Port& port_;
  std::uint64_t last_;
};

inline Failure bad_argument(Argument argument) {
  return {Status::bad_argument, 0, static_cast<std::uint32_t>(argument), 0};
}

// A place of the world in the scene's coordinates, to the same bits as on the workstation.
inline Vec2 local_of(const Scene& scene, const Triple& place) {
  const format::Header& header = scene.header();
  return {static_cast<float>(place.x - header.origin_x), static_cast<float>(place.y - header.origin_y)};
}

// The pose that is asked for, or the scene's first start.
inline ScenePose start_of(const Scene& scene, const Request& request) {
  if (!request.has_start) return scene.start(0);
  ScenePose start{};
  start.position = local_of(scene, request.start);
  start.heading = static_cast<float>(request.start.third);
  return start;
}

// The disc or pose that is asked for, or the scene's first goal.
inline Goal goal_of(const Scene& scene, const Request& request) {
  if (!request.has_goal) return Goal::named(0);
  const Vec2 center = local_of(scene, request.goal);
  const auto radius = static_cast<float>(request.goal.third);
  if (!request.has_heading) return Goal::disc(center, radius);
  return Goal::pose(center, radius, static_cast<float>(request.heading), static_cast<float>(request.heading_tolerance));
}

// The robot standing still at the start; trailers at the start's angles, or all at its heading.
template <class R>
Failure rest_at_start(const Scene& scene, const R& robot, const Request& request, float* state) {
  if (!request.has_start && scene.start_count() == 0) return bad_argument(Argument::start);
  const ScenePose start = start_of(scene, request);
  if constexpr (requires { robot.rest(start.position, start.heading, nullptr, state); }) {
    const bool straight = start.angle_count == 0 || request.trailers == 0;
    if (!straight && start.angle_count != static_cast<std::uint32_t>(request.trailers)) {
      return bad_argument(Argument::start);
    }
    robot.rest(start.position, start.heading, straight ? nullptr : start.angles, state);
  } else {
    robot.rest(start.position, start.heading, state);
  }
  return {};
}

// Everything before the first expansion.
template <class R>
Failure set_up(const Board& board, const Request& request, const R& robot, Scene& scene, Planner<R>& planner) {
  const Failure opened = open_scene(board, scene);
  if (!opened.ok()) return opened;
  float state[R::kMaxState];
  const Failure placed = rest_at_start(scene, robot, request, state);
  if (!placed.ok()) return placed;
  const std::uint64_t bytes = block_bytes(board, request);
  if (bytes > board.arena_room) return {Status::arena_too_small, 0, 0, bytes};
  Limits limits = Planner<R>::limits_for(bytes, scene, robot);
  limits.iterations = request.iterations;
  const Failure ready = planner.init(board.arena, bytes, scene, robot, Parameters(), limits);
  if (!ready.ok()) return ready;
  (void)planner.start({state, goal_of(scene, request), request.seed});
  return planner.failure();
}

template <class R>
void plan_for(const Board& board, const Request& request, const R& robot, Report& report) {
  static Scene scene;         // far too large for a small stack
  static Planner<R> planner;  // likewise
  Stopwatch watch(board.port);
  report.failure = set_up(board, request, robot, scene, planner);
  report.setup = watch.lap();
  report.nanoseconds = report.setup;
  while (report.failure.status == Status::searching) {
    (void)planner.advance(1);
    report.failure = planner.failure();
    const std::uint64_t lap = watch.lap();
    report.nanoseconds += lap;
    if (lap > report.slowest) report.slowest = lap;
  }
  if (report.failure.status != Status::bad_scene) report.scene = scene.name();
  report.statistics = planner.statistics();
}

}  // namespace krait::firmware
