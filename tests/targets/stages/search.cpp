// SPDX-License-Identifier: Apache-2.0
// Whole searches: every state that was ever placed, in order, then the counts and the plan; and how starts in narrow
// places are left.
#include <optional>

#include "krait/krait.hpp"
#include "krait/robots/detail/defaults.hpp"
#include "stages.hpp"

namespace krait::stages {
namespace {

constexpr std::uint64_t kBlock = 256 * 1024;
constexpr std::uint64_t kIterations = 250;

// A robot that hashes each state whose bodies are placed: the tree's and those between them.
template <RobotModel R>
class Witness : public R {
 public:
  explicit Witness(const R& robot) : R(robot) {}

  void place(StateView s, Pose* poses) const {
    seen_.add(s.data(), static_cast<int>(s.size()));
    R::place(s, poses);
  }

  void forget() const { seen_ = {}; }
  const Hash& seen() const { return seen_; }

 private:
  mutable Hash seen_;
};

void add_counts(const Statistics& statistics, Hash& hash) {
  hash.add(statistics.iterations);
  hash.add(statistics.vertices);
  hash.add(statistics.collision_checks);
  hash.add(statistics.recycled);
  hash.add(statistics.dijkstra_runs);
  hash.add(statistics.regions_repaired);
  hash.add(statistics.bytes_used);
}

void add_plan(const Plan& plan, Hash& hash) {
  hash.add(plan.hash());
  hash.add(plan.steps());
  hash.add(plan.length());
}

template <RobotModel R>
void search(const firmware::Board& board, const Scene& scene, const char* name, const R& watched) {
  static Planner planner;
  static std::optional<Witness<R>> witness;
  const Witness<R>& robot = witness.emplace(watched);
  Hash tree;
  Hash plan;
  float start[R::kMaxState];
  const ScenePose pose = scene.start(0);
  (void)detail::rest(robot, pose.position, pose.heading, pose.angles, pose.angle_count, start);
  robot.forget();
  const bool ready = planner.init({board.arena, kBlock, &scene, robot}, {}, {.iterations = kIterations}).ok();
  tree.add(std::uint32_t{ready});
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    (void)planner.start({start, Goal::named(0), seed});
    while (planner.advance(1) == Status::searching) add_counts(planner.statistics(), tree);
    plan.add(static_cast<std::uint32_t>(planner.status()) - static_cast<std::uint32_t>(Status::searching));
    add_plan(planner.plan(), plan);
  }
  tree.add(robot.seen().value());
  report(board, {scene.name(), name, "tree"}, tree);
  report(board, {scene.name(), name, "plan"}, plan);
}

}  // namespace

void searches(const firmware::Board& board, const Scene& scene) {
  for_each_robot([&](const char* name, const auto& robot) { search(board, scene, name, robot); });
}

// A car that reverses begins anywhere, and leaves where it has not come away after its first expansion.
void departures(const firmware::Board& board, const Scene& scene) {
  constexpr int kStarts = 64;
  static Planner planner;
  ChainParameters reversing = Car::defaults();
  reversing.min_speed = -1.0F;
  static const Car car(reversing);
  Parameters parameters;
  parameters.tuning.stuck_expansions = 1;
  Hash hash;
  hash.add(
      std::uint32_t{planner.init({board.arena, kBlock, &scene, car}, parameters, {.iterations = kIterations}).ok()});
  detail::Random random(17);
  for (int i = 0; i < kStarts; ++i) {
    const Vec2 at = random_in(scene.bounds(), random);
    float start[Car::kMaxState];
    car.rest(at, 2.0F * kPi * random.unit(), nullptr, start);
    hash.add(static_cast<std::uint32_t>(planner.start({start, Goal::named(0), 1})));
    (void)planner.advance(24);
    add_counts(planner.statistics(), hash);
  }
  report(board, {scene.name(), "car", "departures"}, hash);
}

}  // namespace krait::stages
