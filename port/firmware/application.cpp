// SPDX-License-Identifier: Apache-2.0
#include "firmware/application.hpp"

#include <cstddef>
#include <cstring>

#include "firmware/improvement.hpp"

namespace krait::firmware {
namespace {

#ifdef KRAIT_NO_IMPROVEMENT
constexpr bool kImproves = false;
#else
constexpr bool kImproves = true;
#endif

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

Failure bad_argument(Argument argument) { return {Status::bad_argument, 0, static_cast<std::uint32_t>(argument), 0}; }

// A place of the world in the scene's coordinates, to the same bits as on the workstation.
Vec2 local_of(const Scene& scene, const Triple& place) {
  const format::Header& header = scene.header();
  return {static_cast<float>(place.x - header.origin_x), static_cast<float>(place.y - header.origin_y)};
}

// The pose of --start, or the scene's first start.
ScenePose start_of(const Scene& scene, const Request& request) {
  if (!request.has_start) return scene.start(0);
  ScenePose start{};
  start.position = local_of(scene, request.start);
  start.heading = static_cast<float>(request.start.third);
  return start;
}

// The disc or pose of --goal, or the scene's first goal.
Goal goal_of(const Scene& scene, const Request& request) {
  if (!request.has_goal) return Goal::named(0);
  const Vec2 center = local_of(scene, request.goal);
  const auto radius = static_cast<float>(request.goal.third);
  if (!request.has_heading) return Goal::disc(center, radius);
  return Goal::pose(center, radius, static_cast<float>(request.heading), static_cast<float>(request.heading_tolerance));
}

Parameters parameters_of(const Request& request) {
  Parameters parameters;
  if (request.has_clearance) parameters.clearance = static_cast<float>(request.clearance);
  if (request.has_dt) parameters.dt = static_cast<float>(request.dt);
  return parameters;
}

// Everything before the first expansion. Not inlined, so that its arrays are not on the stack while the planner plans.
[[gnu::noinline]] Failure set_up(const Board& board, const Request& request, const Robot& robot, Scene& scene,
                                 Planner& planner) {
  const Failure opened = open_scene(board, scene);
  if (!opened.ok()) return opened;
  float state[kMaxState];
  const Failure placed = rest_at_start(scene, robot, request, state);
  if (!placed.ok()) return placed;
  const std::uint64_t bytes = block_bytes(board, request, robot);
  if (bytes > board.arena_room) return {Status::arena_too_small, 0, 0, bytes};
  const Failure ready = init_with_room(planner, {board.arena, bytes, &scene, robot}, parameters_of(request),
                                       request.iterations, request.improve);
  if (!ready.ok()) return ready;
  (void)planner.start({state, goal_of(scene, request), request.seed});
  return planner.failure();
}

// Looks for better plans than the first.
void look_on(Planner& planner, const Request& request, Stopwatch& watch, Report& report) {
  Improvement& improvement = report.improvement;
  improvement.first_steps = report.statistics.plan_steps;
  improvement.first_length = report.statistics.plan_length;
  improvement.first_duration = report.statistics.plan_duration;
  improve(planner, request.improve, [&] {
    const bool goes_on = planner.improve(1) == Status::solved;
    const std::uint64_t lap = watch.lap();
    ++improvement.iterations;
    improvement.nanoseconds += lap;
    if (lap > improvement.slowest) improvement.slowest = lap;
    return goes_on;
  });
  report.failure = planner.failure();
  report.statistics = with_plan_of(report.statistics, planner.statistics());
}

void plan(const Board& board, const Request& request, Report& report) {
  static Scene scene;      // far too large for a small stack
  static Planner planner;  // too large for a small stack, too
  Stopwatch watch(board.port);
  report.failure = set_up(board, request, robot_for(request), scene, planner);
  report.setup = watch.lap();
  report.nanoseconds = report.setup;
  while (report.failure.status == Status::searching) {
    (void)planner.advance(1);
    report.failure = planner.failure();
    const std::uint64_t lap = watch.lap();
    report.nanoseconds += lap;
    if (lap > report.slowest) report.slowest = lap;
  }
  report.statistics = planner.statistics();
  if (kImproves && report.failure.status == Status::solved) look_on(planner, request, watch, report);
  if (kGivesReasons && explains(report.failure.status)) report.why = ask_why(planner, scene);
  if (report.failure.status != Status::bad_scene) report.scene = scene.name();
}

}  // namespace

Failure open_scene(const Board& board, Scene& scene) {
  std::uint32_t size = 0;  // a scene is aligned to 4 bytes only, its header's type to 8
  if (board.scene_room >= sizeof(format::Header)) {
    std::memcpy(&size, static_cast<const std::byte*>(board.scene) + offsetof(format::Header, total_bytes), sizeof size);
  }
  return Scene::open(board.scene, size > board.scene_room ? board.scene_room : size, scene);
}

std::uint64_t block_bytes(const Board& board, const Request& request, const Robot& robot) {
  constexpr std::uint64_t kKilobyte = 1024;
  constexpr int kShortRobot = 6;  // bodies
  if (request.memory > 0) return request.memory;
  const std::uint64_t wanted = (robot.body_count() <= kShortRobot ? 128 : 256) * kKilobyte;
  return wanted < board.arena_room ? wanted : board.arena_room;
}

Failure rest_at_start(const Scene& scene, const Robot& robot, const Request& request, float* state) {
  if (!request.has_start && scene.start_count() == 0) return bad_argument(Argument::start);
  const ScenePose start = start_of(scene, request);
  const bool fits = robot.rest(start.position, start.heading, start.angles, start.angle_count, state);
  return fits ? Failure{} : bad_argument(Argument::start);
}

int run(const Board& board, int count, const char* const* words) {
  Request request;
  const char* const complaint = parse(count, words, kModel, kHasTrailers, request);
  if (complaint == kUnknownOption) return refuse(board, complaint, request.unknown, kKnownOptions);
  if (complaint != nullptr) return refuse(board, complaint, complaint == kAnotherRobot ? kModel : "");
  if (!kImproves && request.improve > 0.0)
    return refuse(board, "--improve: this firmware is built with KRAIT_IMPROVE=OFF");
  Report report;
  plan(board, request, report);
  return write(board, request, report);
}

}  // namespace krait::firmware
