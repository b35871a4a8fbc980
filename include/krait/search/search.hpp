// What every planner of the library shares: its memory, the query's checks, the motion tree, the steps of an expansion
// (Algorithm 2, lines 4 to 15), and the plan at the end.
#pragma once

#include "krait/arena.hpp"
#include "krait/arithmetic.hpp"
#include "krait/collision/motion_check.hpp"
#include "krait/decomposition/locate.hpp"
#include "krait/decomposition/regions.hpp"
#include "krait/motion/rk4.hpp"
#include "krait/plan.hpp"
#include "krait/random.hpp"
#include "krait/robot/robot.hpp"
#include "krait/robot/shape.hpp"
#include "krait/search/motion_tree.hpp"
#include "krait/search/parameters.hpp"
#include "krait/search/statistics.hpp"

namespace krait {

struct Query {
  const float* start = nullptr;  // robot.state_size() floats, copied
  Goal goal = Goal::named(0);
  std::uint64_t seed = 1;
};

// `Guide` is what a planner keeps by vertex to choose where to grow from. It has
//   take(arena, scene, vertices)   its pools
//   scratch()                      one Index a vertex, free once the search has ended
template <Robot R, class Guide>
class Search {
 public:
  // Bytes of the block that init needs. The same on every target. O(1).
  static std::uint64_t bytes_required(const Scene& scene, const R& robot, const Limits& limits) {
    Arena counting;
    Search search;
    search.robot_ = &robot;
    search.scene_ = &scene;
    search.limits_ = limits;
    search.take_pools(counting);
    return counting.needed();
  }

  // The limits that spend a block of `bytes` best: as many vertices as fit, at least 2. O(1).
  static Limits limits_for(std::uint64_t bytes, const Scene& scene, const R& robot) {
    Limits limits;
    std::uint32_t fits = 2;
    std::uint32_t too_many = kMostVertices;
    while (too_many - fits > 1) {
      limits.vertices = fits + (too_many - fits) / 2;
      (bytes_required(scene, robot, limits) <= bytes ? fits : too_many) = limits.vertices;
    }
    limits.vertices = fits;
    return limits;
  }

  // Takes the block, which like robot and scene must outlive the planner and stay where it is. Gives solved, or why
  // not: bad_arithmetic, bad_robot, bad_argument, arena_too_small. May be called again.
  Failure init(void* block, std::uint64_t bytes, const Scene& scene, const R& robot, const Parameters& parameters,
               const Limits& limits) {
    ready_ = false;
    if (!check_setup(robot, scene, parameters, limits).ok()) return failure_;
    const std::uint64_t needed = bytes_required(scene, robot, limits);
    if (bytes < needed) return failure_ = {Status::arena_too_small, 0, 0, needed};
    const bool usable = block != nullptr && reinterpret_cast<std::uintptr_t>(block) % Arena::kAlignment == 0;
    if (!usable) return failure_ = bad_argument(Argument::block);
    arena_ = Arena(block, bytes);
    take_pools(arena_);
    statistics_ = {};
    statistics_.bytes_given = bytes;
    statistics_.bytes_used = needed;
    ready_ = true;
    failure_ = bad_argument(Argument::start);  // until there is one
    return {};
  }

  // What init cut the block into: Arena::needed(Pool) bytes a pool. Of the pools that grow with the tree,
  // statistics().vertices of limits.vertices shares are in use.
  const Arena& arena() const { return arena_; }
  const MotionTree& tree() const { return tree_; }
  const Regions& regions() const { return regions_; }
  Status status() const { return failure_.status; }
  const Failure& failure() const { return failure_; }

  // Ends the search as time_used, for a port whose clock says so. No effect once it has ended.
  void stop_for_time() {
    if (status() == Status::searching) finish(Status::time_used);
  }

  // Empty unless solved. Valid until the next start.
  Plan plan() const {
    if (path_states_ == 0) return {};
    return {tree_, path_, path_states_, parameters_.dt, robot_->state_size(), robot_->control_size()};
  }

  Statistics statistics() const {
    Statistics result = statistics_;
    result.vertices = tree_.size();
    result.collision_checks = check_.checks();
    return result;
  }

 protected:
  enum class Expansion { goal_reached, target_reached, target_not_reached, collision, tree_full };

  struct Expanded {
    Expansion result;
    Index last;  // the last vertex that was added, or where the expansion began
  };

  // Whether init has succeeded: start needs it, else it gives init's answer again.
  bool ready() const { return ready_; }

  // Checks the query, computes the heuristic costs and plants the root. searching when the search can begin; solved
  // when the start lies in the goal.
  Status begin(const Query& query) {
    path_states_ = 0;
    const std::uint64_t given = statistics_.bytes_given;
    const std::uint64_t used = statistics_.bytes_used;
    statistics_ = {};
    statistics_.bytes_given = given;
    statistics_.bytes_used = used;
    tree_.clear();
    random_ = Random(query.seed);
    check_.assign(*robot_, *scene_, parameters_.clearance, static_cast<int>(parameters_.max_substeps));
    goal_ = query.goal;
    failure_ = check_query(query);
    if (status() != Status::searching) return status();
    const float tenth = 0.1F * goal_.size(*scene_);
    goal_depth_ = parameters_.goal_margin < tenth ? parameters_.goal_margin : tenth;
    const bool fits = !parameters_.prune_portals || body_fits_through(query.start);
    if (!regions_.reset(goal_, least_portal_width(), kLeastCost * robot_length_)) {
      return finish(Status::goal_in_obstacle);
    }
    ++statistics_.dijkstra_runs;
    const Status planted = plant(query.start);
    return planted == Status::searching && !fits ? finish(Status::no_route) : planted;
  }

  // Algorithm 2, lines 4 to 15: from vertex v toward the target. `added(vertex)` hears of every new vertex.
  template <class Added>
  Expanded expand(Index v, const Target& target, Added added) {
    Steering steering;
    const float near = parameters_.near_radius * robot_length_;
    if (parameters_.continuous) check_.begin(tree_.state(v));
    for (std::uint32_t step = 0; step < parameters_.max_steps; ++step) {
      if (tree_.full()) return {Expansion::tree_full, v};
      const Index next = tree_.size();  // its state and control are written in place; it exists once they are good
      if (!take_step(v, target, steering, tree_.control(next), tree_.state(next))) return {Expansion::collision, v};
      const Vec2 at = {tree_.state(next)[0], tree_.state(next)[1]};
      tree_.add(v, region_of(at, tree_.region(v)));
      added(next);
      if (reached_goal(at)) return {Expansion::goal_reached, next};
      if (length(target.point - at) <= near) return {Expansion::target_reached, next};
      v = next;
    }
    return {Expansion::target_not_reached, v};
  }

  // One iteration more; false when the budget is used up.
  bool count_iteration() {
    if (statistics_.iterations == limits_.iterations) {
      finish(Status::budget_used);
      return false;
    }
    ++statistics_.iterations;
    return true;
  }

  Target target_at(Vec2 point) {
    const float speed = random_speed();
    return {point, speed, parameters_.dt};
  }

  Vec2 random_point_in_bounds() {
    const Box bounds = scene_->bounds();
    const float u = random_.unit();
    const float v = random_.unit();
    return {bounds.min.x + u * (bounds.max.x - bounds.min.x), bounds.min.y + v * (bounds.max.y - bounds.min.y)};
  }

  float random_speed() {
    const bool backward = reversible(*robot_) && random_.unit() < parameters_.reverse_share;
    const float share = parameters_.slowest + (1.0F - parameters_.slowest) * random_.unit();
    return backward ? -share : share;
  }

  Status finish(Status status) {
    failure_ = {status};
    return status;
  }

  // Ends the search with the plan that leads to vertex `last`, after replaying it.
  Status finish_solved(Index last) {
    Index* const memory = guide_.scratch();
    std::uint32_t states = 0;
    for (Index v = last; v != kNone; v = tree_.parent(v)) ++states;
    Index place = states;
    for (Index v = last; v != kNone; v = tree_.parent(v)) memory[--place] = v;
    path_ = memory;
    path_states_ = states;
    if (!replays()) {
      path_states_ = 0;
      return finish(Status::internal);
    }
    const Plan solution = plan();
    statistics_.plan_steps = solution.steps();
    statistics_.plan_length = solution.length();
    statistics_.plan_duration = solution.duration();
    statistics_.hash = solution.hash();
    return finish(Status::solved);
  }

  const R* robot_ = nullptr;
  const Scene* scene_ = nullptr;
  Parameters parameters_;
  Limits limits_;
  Arena arena_;
  Failure failure_ = bad_argument(Argument::block);  // until init has one
  Statistics statistics_;
  Regions regions_;
  MotionTree tree_;
  Guide guide_;
  MotionCheck<R> check_;
  Random random_;
  Goal goal_ = Goal::named(0);
  float robot_length_ = 1.0F;

 private:
  static constexpr float kReachRounding = 1e-2F;  // metres
  static constexpr float kLeastCost = 0.05F;      // of an edge, in robot lengths: keeps h + C above h
  static constexpr std::uint32_t kMostVertices = 1U << 28U;

  static Failure bad_argument(Argument argument) {
    return {Status::bad_argument, 0, static_cast<std::uint32_t>(argument)};
  }

  void take_pools(Arena& arena) {
    regions_.take(arena, *scene_);
    tree_.take(arena, limits_.vertices, robot_->state_size(), robot_->control_size());
    guide_.take(arena, *scene_, limits_.vertices);
  }

  // The arguments that do not change between queries. Gives solved, or what is wrong.
  Failure check_setup(const R& robot, const Scene& scene, const Parameters& parameters, const Limits& limits) {
    robot_ = &robot;
    scene_ = &scene;
    parameters_ = parameters;
    limits_ = limits;
    path_states_ = 0;
    if (!exact_arithmetic()) return failure_ = {Status::bad_arithmetic};
    const Argument bad_robot = first_bad_of_robot(robot);
    if (bad_robot != Argument::none) return failure_ = {Status::bad_robot, 0, static_cast<std::uint32_t>(bad_robot)};
    Argument bad = parameters.first_bad();
    if (bad == Argument::none && limits.vertices < 2) bad = Argument::vertices;
    if (bad == Argument::none && limits.iterations < 1) bad = Argument::iterations;
    if (bad != Argument::none) return failure_ = bad_argument(bad);
    robot_length_ = krait::robot_length(robot);
    return failure_ = {};
  }

  Failure check_query(const Query& query) {
    if (query.start == nullptr) return bad_argument(Argument::start);
    for (int i = 0; i < robot_->state_size(); ++i) {
      if (!finite(query.start[i])) return bad_argument(Argument::start);
    }
    if (!goal_.valid(*scene_)) return bad_argument(Argument::goal);
    if (!scene_->inside_bounds({query.start[0], query.start[1]})) return {Status::start_outside};
    if (!robot_->within_limits(StateView(query.start, robot_->state_size()))) return bad_argument(Argument::start);
    if (!check_.free(query.start)) return {Status::start_in_collision};
    return {Status::searching};
  }

  Status plant(const float* start) {
    const Vec2 at{start[0], start[1]};
    const Index triangle = locate(*scene_, at);
    if (triangle == kNone) return finish(Status::start_in_collision);
    const Index root = tree_.add(kNone, regions_.region(triangle));
    for (int i = 0; i < robot_->state_size(); ++i) tree_.state(root)[i] = start[i];
    for (int i = 0; i < robot_->control_size(); ++i) tree_.control(root)[i] = 0.0F;
    if (regions_.cost(tree_.region(root)) == kInfinity) return finish(Status::no_route);
    if (goal_.contains(*scene_, at, 0.0F)) return finish_solved(root);
    return finish(Status::searching);
  }

  // No obstacle comes nearer to the position than the disc around it that lies in body 0, if there is one.
  float least_portal_width() const {
    const float inner = inner_radius(robot_->body(0), {});
    return parameters_.prune_portals && inner > 0.0F ? 2.0F * (inner + parameters_.clearance) : 0.0F;
  }

  // The disc in body 0 goes where the body goes: where it finds no way from the start to so near the goal that the
  // position could be inside, there is none. False then.
  bool body_fits_through(const float* start) {
    const Polygon body = robot_->body(0);
    const Vec2 center = middle(body);
    Pose poses[R::kMaxBodies];
    robot_->place(StateView(start, robot_->state_size()), poses);
    const Vec2 at = poses[0].position + turned(poses[0].heading, center);
    const Index triangle = locate(*scene_, at);
    if (triangle == kNone) return true;
    const float width = 2.0F * (inner_radius(body, center) + parameters_.clearance);
    return regions_.connected(triangle, goal_, length(center) + kReachRounding, width);
  }

  // CONTROLLER, MOTION and COLLISION (lines 5 and 6). False when the step is not free or leaves the robot's limits.
  bool take_step(Index v, const Target& target, Steering& steering, float* control, float* next) {
    const StateView state(tree_.state(v), robot_->state_size());
    robot_->steer(state, target, steering, ControlRef(control, robot_->control_size()));
    propagate(*robot_, tree_.state(v), control, parameters_.dt, next);
    const StateView after(next, robot_->state_size());
    const ControlView held(control, robot_->control_size());
    if (!robot_->within_limits(after) || !keeps_limits(*robot_, state, held, parameters_.dt, after)) return false;
    if (!scene_->inside_bounds({next[0], next[1]})) return false;
    if (parameters_.continuous) return check_.step_free(tree_.state(v), control, parameters_.dt, next);
    return check_.free(next);
  }

  // The region of a position; where no triangle contains it (a reference point outside the body may stand on an
  // obstacle), the parent's.
  Index region_of(Vec2 at, Index parent) const {
    const Index triangle = locate(*scene_, at, parent);
    return triangle == kNone ? parent : regions_.region(triangle);
  }

  bool reached_goal(Vec2 at) const { return goal_.contains(*scene_, at, goal_depth_); }

  bool replays() const {
    const Plan solution = plan();
    float next[R::kMaxState];
    for (std::uint32_t i = 0; i < solution.steps(); ++i) {
      propagate(*robot_, solution.state(i), solution.control(i), parameters_.dt, next);
      for (int k = 0; k < robot_->state_size(); ++k) {
        if (next[k] != solution.state(i + 1)[k]) return false;
      }
    }
    return true;
  }

  bool ready_ = false;
  float goal_depth_ = 0.0F;
  Index* path_ = nullptr;
  std::uint32_t path_states_ = 0;
};

}  // namespace krait
