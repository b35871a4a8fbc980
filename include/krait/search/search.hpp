// SPDX-License-Identifier: Apache-2.0
// What every planner of the library shares: its memory, the query's checks, the motion tree, the steps of an expansion
// (Algorithm 2, lines 4 to 15), and the plan at the end.
#pragma once

#include "krait/base/arena.hpp"
#include "krait/base/arithmetic.hpp"
#include "krait/base/random.hpp"
#include "krait/collision/goal_room.hpp"
#include "krait/collision/motion_check.hpp"
#include "krait/decomposition/locate.hpp"
#include "krait/decomposition/regions.hpp"
#include "krait/improve/improver.hpp"
#include "krait/motion/drive.hpp"
#include "krait/parameters.hpp"
#include "krait/plan/ending.hpp"
#include "krait/plan/motion_tree.hpp"
#include "krait/plan/plan.hpp"
#include "krait/plan/plan_proof.hpp"
#include "krait/robot/robot.hpp"
#include "krait/robot/shape.hpp"
#include "krait/search/last_metres.hpp"
#include "krait/search/restarts.hpp"
#include "krait/search/statistics.hpp"
#include "krait/search/watch.hpp"

namespace krait {

struct Query {
  const float* start = nullptr;  // robot.state_size() floats, copied; the position in the scene's local coordinates
  Goal goal = Goal::named(0);
  std::uint64_t seed = 1;
};

// `Guide` is what a planner keeps by vertex to choose where to grow from: take(arena, scene, vertices) allocates it.
// `Derived` is the planner, which has
//   reset_guide()                  resets the guide
//   restart_unit()                 as Restarts::begin has it
//   doomed_steps()                 Parameters::doomed_steps or 0
//   open_steps()                   Parameters::open_steps or 0
//   slowest()                      Parameters::slowest or another such share
//   end_speed()                    Parameters::end_speed or infinity
//   shoots()                       whether it may drive the last metres to a pose, so that an expansion may go on
//   iterate(watch)                 one expansion
//   keep(region, branch, state)    hears of every new state that is not doomed, and may keep it as a vertex; false when
//                                  it cannot go on
template <class Derived, class Guide>
class Search {
 public:
  Search() = default;
  // A copy would write to the same block.
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  // Bytes of the block that init needs. The same on every target. O(1).
  static std::uint64_t bytes_required(const Scene& scene, const Robot& robot, const Limits& limits) {
    Arena counting;
    Regions regions;
    MotionTree tree;
    Guide guide;
    Improver improver;
    take_pools(counting, scene, robot, limits, regions, tree, guide, improver);
    return counting.needed();
  }

  // The limits that spend a block of `bytes` best: as many vertices and expansions as fit beside `way_legs` legs, at
  // least 2. O(1).
  static Limits limits_for(std::uint64_t bytes, const Scene& scene, const Robot& robot, std::uint32_t way_legs = 0) {
    Limits limits;
    limits.way_legs = way_legs;
    std::uint32_t fits = 2;
    std::uint32_t too_many = MotionTree::kMostExpansions + 1;
    while (too_many - fits > 1) {
      limits.vertices = fits + (too_many - fits) / 2;
      (bytes_required(scene, robot, limits) <= bytes ? fits : too_many) = limits.vertices;
    }
    limits.vertices = fits;
    return limits;
  }

  // Uses the block, aligned to Arena::kAlignment, which like robot and scene must outlive the planner and stay where
  // it is; copies parameters and limits. Returns ok, or why not: bad_arithmetic, bad_argument (a scene that was not
  // opened, too), bad_robot, arena_too_small. May be called again.
  [[nodiscard]] Failure init(void* block, std::uint64_t bytes, const Scene& scene, const Robot& robot,
                             const Parameters& parameters, const Limits& limits) {
    ready_ = false;
    if (!check_setup(robot, scene, parameters, limits).ok()) return failure_;
    const std::uint64_t needed = bytes_required(scene, robot, limits);
    if (bytes < needed) return failure_ = {Status::arena_too_small, 0, 0, needed};
    const bool usable = block != nullptr && reinterpret_cast<std::uintptr_t>(block) % Arena::kAlignment == 0;
    if (!usable) return failure_ = bad_argument(Argument::block);
    fingerprint_ = scene.fingerprint();
    arena_ = Arena(block, bytes);
    take_pools(arena_, scene, robot, limits, regions_, tree_, guide_, improver_);
    statistics_ = {};
    ready_ = true;
    failure_ = {Status::ready};
    return {};
  }
  // Temporaries would not outlive the planner.
  Failure init(void*, std::uint64_t, const Scene&&, const Robot&, const Parameters&, const Limits&) = delete;

  // Begins a search, ending any other. Returns searching; or solved, when a plan may end with the start; or no_route,
  // goal_in_obstacle, start_outside, start_in_collision, bad_argument; bad_scene, when the scene is found to be another
  // than at init (Scene::fingerprint); after an init that failed, what that one gave. Work: a Dijkstra, 2730 distances.
  [[nodiscard]] Status start(const Query& query) {
    if (!ready_) return status();
    if (scene_->fingerprint() != fingerprint_) return scene_changed();
    derived().reset_guide();
    restarts_.begin(derived().restart_unit());
    return begin(query);
  }

  // At most `iterations` expansions more; returns at once when the search has ended. Where an expansion comes so near
  // to the goal that braking may end there, it brakes, and from every fourth state near a pose it drives the shortest
  // few of at most 216 lines to it (last_metres.hpp); such steps count as steps of the expansion for the work of a
  // call, and it goes on where they lead to nothing. A way that has reached the goal is driven once more before it is
  // returned as a plan: up to max_steps steps of it count as one of `iterations` here, but not in Statistics and
  // Limits. The result does not depend on how a search is cut into calls.
  [[nodiscard]] Status advance(std::uint64_t iterations) { return advance(iterations, Watch()); }

  // The same, and calls watch(from, to), states, for every step that the tree grows by; before an expansion
  // watch.expands(vertex, target), where there is such a member.
  [[nodiscard]] Status advance(std::uint64_t iterations, const Watch& watch) {
    for (; iterations > 0 && status() == Status::searching; --iterations) {
      if (driving()) {
        drive_plan();
        continue;
      }
      if (statistics_.iterations == limits_.iterations) return finish(Status::budget_used);
      ++statistics_.iterations;
      if (restarts_.due()) {
        begin_anew();
      } else {
        derived().iterate(watch);
      }
    }
    return status();
  }

  // At most `iterations` more of looking for a plan of fewer steps; plan() and Statistics::plan_steps, plan_length,
  // plan_duration and hash are then those of the best so far, which was driven and proven as the first one was. Work of
  // one, which must end in the goal as the first did, so that few are found for a pose: at most max_steps steps, and 16
  // legs' steps that are not proven, or O(way_legs); the first call after start begins with one Dijkstra. The result
  // does not depend on how the iterations are cut into calls. Plans and their cursors from before the call end with it.
  // Returns status() and does nothing where that is not solved or the plan has no steps; bad_argument where
  // Limits::way_legs is 0.
  [[nodiscard]] Status improve(std::uint64_t iterations) {
    if (status() != Status::solved || path_ == kNone) return status();
    if (limits_.way_legs == 0) return Status::bad_argument;
    if (!improving_) begin_to_improve();
    for (; iterations > 0; --iterations) {
      if (!improver_.iterate()) continue;
      ++statistics_.improvements;
      note(improver_.measures());
    }
    return status();
  }

  // What init cut the block into: Arena::needed(Pool) bytes a pool.
  const Arena& arena() const { return arena_; }
  const MotionTree& tree() const { return tree_; }
  const Regions& regions() const { return regions_; }
  const Guide& guide() const { return guide_; }
  // Where the search stands: ready before the first start; before init, bad_argument.
  [[nodiscard]] Status status() const { return failure_.status; }
  [[nodiscard]] const Failure& failure() const { return failure_; }

  // After start_in_collision: what the robot is too near to at its start; else Hindrance::none. O(pieces near the robot
  // + bodies^2).
  Contact contact() {
    if (status() != Status::start_in_collision) return {};
    Contact contact = check_.contact(drive_.state());
    if (contact.with == Hindrance::none) contact = {.with = Hindrance::ground, .at = start_position()};
    return contact;
  }

  // Of a search that ended without a plan: the widest way, which after no_route is too narrow for the robot; all zero
  // else. Work: at most two Dijkstras for the widest way, two for the costs, and 4,095 distances of a point.
  Bottleneck bottleneck() {
    const Status ended = status();
    if (ended == Status::no_route) {
      const Bottleneck bottleneck = bottleneck_for(body_disc());
      return bottleneck.width < bottleneck.needed ? bottleneck : bottleneck_for(position_disc());
    }
    const bool in_vain = ended == Status::budget_used || ended == Status::tree_full || ended == Status::time_used;
    return in_vain ? bottleneck_for(body_disc()) : Bottleneck{};
  }

  // Whether a way has reached the goal and is driven once more; the tree does not grow meanwhile.
  bool driving() const { return driven_ != kNone; }

  // Ends the search as time_used, for a port whose clock says so. No effect once it has ended.
  void stop_for_time() {
    if (status() == Status::searching) finish(Status::time_used);
  }

  // Empty unless solved. Valid until the next start or improve.
  Plan plan() const {
    if (status() != Status::solved) return {};
    return {robot_, improving_ ? improver_.plan() : found_path(), tree_.state(kRoot), parameters_.dt};
  }

  Statistics statistics() const {
    Statistics result = statistics_;
    result.collision_checks = check_.checks();
    if (ready_) {
      result.bytes_given = arena_.bytes();
      result.bytes_used = arena_.needed() - tree_.bytes_untouched();
    }
    return result;
  }

 protected:
  static constexpr std::uint32_t kPatience = 10;  // tries after which half of the gentle share turns gently

  enum class Expansion { goal_reached, target_reached, target_not_reached, collision, tree_full, goes_on };

  struct Expanded {
    Expansion result;
    Index region;               // of the last state
    Branch last;                // the last state, when there was a step
    std::uint32_t crossed = 0;  // how often a step ended in another region than it began in
  };

  // Algorithm 2, lines 4 to 15: from a vertex, which lies in `region` (or kNone: not known), toward the target. The
  // tree must have room for an expansion. Where it goes_on, that is for go_on.
  Expanded expand(Index vertex, Index region, const Target& toward, const Watch& watch) {
    const Index expansion = tree_.begin_expansion(tree_.branch(vertex), toward);
    drive_.begin(tree_.state(vertex));
    check_.begin(drive_.state());
    drive_.aim(tree_.target(expansion));
    watch.expands(vertex, drive_.target());
    expanded_ = {Expansion::target_not_reached, region, {expansion, 0}};
    apart_ = kInfinity;
    return drive(expanded_, watch);
  }

  // The next max_steps steps of a long expansion.
  Expanded go_on(const Watch& watch) {
    restarts_.uncount();
    return drive(expanded_, watch);
  }

  // The way to a point at a random speed, and in a turn that is gentle the more often, the more often it was tried.
  Target any_way_to(Vec2 point, std::uint32_t tries) {
    Target target;
    target.point = point;
    const bool backward = robot_.reversible() && random_.unit() < parameters_.reverse_share;
    const float slowest = derived().slowest();
    const float share = slowest + (1.0F - slowest) * random_.unit();
    target.speed = backward ? -share : share;
    const auto patience = static_cast<float>(tries) / static_cast<float>(tries + kPatience);
    if (random_.unit() < parameters_.gentle_share * patience) {
      target.turn = kGentlest + (1.0F - kGentlest) * random_.unit();
    }
    return target;
  }

  // Lets the robot drive to a target in the goal so slowly that it can stop there.
  void slow_for(Target& target, Index from) const {
    if (!ending_.limits_speed()) return;
    const float way = absolute(robot_.stopping_way(tree_.state(from)));
    const float distance = length(target.point - position(from));
    if (distance < way) target.speed = target.speed * std::sqrt(distance / way);
  }

  Vec2 random_point_in_bounds() {
    const Box bounds = scene_->bounds();
    const float u = random_.unit();
    const float v = random_.unit();
    return {bounds.min.x + u * (bounds.max.x - bounds.min.x), bounds.min.y + v * (bounds.max.y - bounds.min.y)};
  }

  Vec2 position(Index vertex) const { return {tree_.state(vertex)[0], tree_.state(vertex)[1]}; }

  Status finish(Status status) {
    failure_ = {status};
    return status;
  }

  Robot robot_;
  const Scene* scene_ = nullptr;
  Parameters parameters_;
  Limits limits_;
  Statistics statistics_;
  Regions regions_;
  MotionTree tree_;
  Guide guide_;
  Drive drive_;
  Random random_;
  float robot_length_ = 1.0F;

 private:
  static constexpr std::uint32_t kRecent = Parameters::kMostDoomedSteps + 1;
  static constexpr std::uint32_t kOpen = 1;       // how often an expansion past max_steps may have crossed a portal
  static constexpr float kGentlest = 0.15F;       // of the sharpest turn
  static constexpr float kReachRounding = 1e-2F;  // metres
  static constexpr float kLeastCost = 0.05F;      // of an edge, in robot lengths: keeps h + C above h
  static constexpr float kStartDepth = 1e-4F;     // metres: how deep inside the goal a plan without steps is
  static constexpr float kDepthKept = 0.1F;       // share of the goal's margin that a plan keeps

  struct NewState {
    Index region;
    float state[kMaxState];
  };

  static Failure bad_argument(Argument argument) {
    return {Status::bad_argument, 0, static_cast<std::uint32_t>(argument)};
  }

  Status scene_changed() {
    failure_ = {Status::bad_scene, Scene::kHeaderSection, offsetof(format::Header, crc32)};
    return status();
  }

  static void take_pools(Arena& arena, const Scene& scene, const Robot& robot, const Limits& limits, Regions& regions,
                         MotionTree& tree, Guide& guide, Improver& improver) {
    regions.take(arena, scene);
    tree.take(arena, limits.vertices, limits.kept_expansions(), robot.state_size());
    guide.take(arena, scene, limits.vertices);
    if (limits.way_legs > 0) improver.take(arena, limits.way_legs, robot.state_size());
  }

  Derived& derived() { return static_cast<Derived&>(*this); }
  const Derived& derived() const { return static_cast<const Derived&>(*this); }

  // The arguments that do not change between queries. Returns solved, or what is wrong.
  Failure check_setup(const Robot& robot, const Scene& scene, const Parameters& parameters, const Limits& limits) {
    robot_ = robot;
    scene_ = &scene;
    parameters_ = parameters;
    limits_ = limits;
    if (!exact_arithmetic() || !robot.exact()) return failure_ = {Status::bad_arithmetic};
    if (scene.bytes() == 0) return failure_ = bad_argument(Argument::scene);
    const Argument bad_robot = first_bad_of_robot(robot);
    if (bad_robot != Argument::none) return failure_ = {Status::bad_robot, 0, static_cast<std::uint32_t>(bad_robot)};
    Argument bad = parameters.first_bad();
    if (bad == Argument::none) bad = limits.first_bad();
    if (bad != Argument::none) return failure_ = bad_argument(bad);
    if (!can_integrate(robot, parameters.dt)) {
      failure_ = bad_argument(Argument::dt);
      failure_.most = longest_time_step(robot, parameters.dt);
      return failure_;
    }
    robot_length_ = krait::robot_length(robot);
    drive_.assign(robot, parameters.dt);
    brake_.assign(robot, parameters.dt);
    return failure_ = {};
  }

  // Checks the query, computes the heuristic costs and plants the root. searching when the search can begin; solved
  // when a plan may end with the start.
  Status begin(const Query& query) {
    statistics_ = {};
    improving_ = false;
    driven_ = kNone;
    braking_ = kNone;
    shooting_ = false;
    random_ = Random(query.seed);
    check_.assign(robot_, *scene_, tree_clearance(), static_cast<int>(parameters_.max_substeps), !parameters_.plain);
    keep_for_tree();
    ending_.assign(robot_, *scene_, query.goal, derived().end_speed());
    tree_.clear(scene_->bounds(), spare_expansions());
    failure_ = check_query(query);
    if (status() != Status::searching) return status();
    if (shoots()) last_metres_.assign(*scene_, query.goal, nimbleness());
    const float tenth = 0.1F * query.goal.size(*scene_);
    goal_depth_ = parameters_.goal_margin < tenth ? parameters_.goal_margin : tenth;
    end_depth_ = {kDepthKept * goal_depth_, tenth};
    const bool fits = !parameters_.prune_portals || body_fits();
    if (!find_paths()) return finish(Status::goal_in_obstacle);
    return plant(fits);
  }

  // Whether the last metres are driven.
  bool shoots() const { return ending_.goal().is_pose() && derived().shoots(); }

  // Those that end a way: a brake or the legs of a shot, which half of a small tree must do for.
  std::uint32_t spare_expansions() const {
    if (!shoots()) return ending_.limits_speed() ? 1 : 0;
    const std::uint32_t half = limits_.kept_expansions() / 2;
    return half < LastMetres::kMostLegs ? half : LastMetres::kMostLegs;
  }

  Nimbleness nimbleness() const {
    const Robot& robot = robot_;
    return {robot_length_,
            robot.turning_radius(robot_length_),
            robot.top_speed(robot_length_),
            inner_radius(robot.body(0), {}),
            robot.reversible() && robot.body_count() == 1,
            parameters_.dt};
  }

  // Resets the edge costs and finds the shortest paths. False when no region belongs to the goal.
  bool find_paths() {
    ++statistics_.dijkstra_runs;
    return regions_.reset(ending_.goal(), least_portal_width(), kLeastCost * robot_length_);
  }

  // Forgets all but the start and where the random numbers have got to.
  void begin_anew() {
    ++statistics_.restarts;
    drive_.begin(tree_.state(kRoot));
    tree_.empty();
    braking_ = kNone;
    shooting_ = false;
    derived().reset_guide();
    find_paths();
    derived().keep(root_region_, {}, drive_.state());
  }

  Failure check_query(const Query& query) {
    if (query.start == nullptr) return bad_argument(Argument::start);
    for (int i = 0; i < robot_.state_size(); ++i) {
      if (!finite(query.start[i])) return bad_argument(Argument::start);
    }
    drive_.begin(query.start);
    if (!ending_.goal().valid(*scene_)) return bad_argument(Argument::goal);
    if (!scene_->inside_bounds({query.start[0], query.start[1]})) return {Status::start_outside};
    if (!robot_.within_limits(query.start)) return bad_argument(Argument::start);
    if (!check_.free(query.start)) return {Status::start_in_collision};
    return {Status::searching};
  }

  Status plant(bool fits) {
    const Vec2 at = start_position();
    const Index triangle = locate(*scene_, at);
    if (triangle == kNone) return finish(Status::start_in_collision);
    root_region_ = regions_.region(triangle);
    statistics_.vertices = 1;
    if (regions_.cost(root_region_) == kInfinity) return finish(Status::no_route);
    derived().keep(root_region_, {}, drive_.state());
    finish(fits ? Status::searching : Status::no_route);
    const float depth = kStartDepth < end_depth_.most ? kStartDepth : end_depth_.most;
    if (ending_.holds(drive_.state(), depth)) begin_plan({});
    return status();
  }

  // Before the first step.
  Vec2 start_position() const { return {drive_.state()[0], drive_.state()[1]}; }

  // A disc that lies in body 0, and goes where the body goes.
  struct InnerDisc {
    Vec2 at;       // its centre at the start
    float radius;  // metres, the clearance included
    float reach;   // metres: how far the centre may be from the goal while the position is inside
  };

  // Around the middle of body 0.
  InnerDisc body_disc() {
    const Polygon body = robot_.body(0);
    const Vec2 center = middle(body);
    check_.begin(drive_.state());
    const Pose& pose = check_.poses()[0];
    const float radius = inner_radius(body, center) + parameters_.clearance;
    return {pose.position + turned(pose.heading, center), radius, length(center) + kReachRounding};
  }

  // Around the position: smaller, but where the position is.
  InnerDisc position_disc() const {
    return {start_position(), inner_radius(robot_.body(0), {}) + parameters_.clearance, 0.0F};
  }

  // No obstacle comes nearer to the position than the disc around it that lies in body 0, if there is one.
  float least_portal_width() const {
    const float inner = inner_radius(robot_.body(0), {});
    return parameters_.prune_portals && inner > 0.0F ? 2.0F * (inner + parameters_.clearance) : 0.0F;
  }

  // Where a disc in body 0 finds no room in the goal, or no way from the start to so near the goal that the position
  // could be inside, there is no way for the robot. False then.
  bool body_fits() {
    const InnerDisc disc = body_disc();
    if (!room_at_goal(position_disc()).enough || !room_at_goal(disc).enough) return false;
    const Index triangle = locate(*scene_, disc.at);
    return triangle == kNone || regions_.connected(triangle, ending_.goal(), disc.reach, 2.0F * disc.radius);
  }

  // Of the points that the disc's centre may be at in the end.
  GoalRoom room_at_goal(const InnerDisc& disc) const {
    const Obstacles obstacles(*scene_, 0.0F);
    return goal_room(*scene_, obstacles, ending_.goal(), disc.reach, disc.radius - 2.0F * obstacles.margin());
  }

  Bottleneck bottleneck_for(const InnerDisc& disc) {
    const float needed = 2.0F * disc.radius;
    const GoalRoom room = room_at_goal(disc);
    if (!room.enough) return {2.0F * room.found, needed, room.at, true};
    const Index triangle = locate(*scene_, disc.at);
    if (triangle == kNone) return {};
    Bottleneck bottleneck = regions_.widest_way(triangle, disc.reach);
    bottleneck.needed = needed;
    return bottleneck;
  }

  // At most max_steps steps, and what becomes of the expansion.
  Expanded drive(Expanded& expanded, const Watch& watch) {
    bool goes = true;
    for (std::uint32_t left = parameters_.max_steps; goes && left > 0; --left) {
      expanded.result = take_turn(expanded, watch);
      const bool under_way = expanded.result == Expansion::target_not_reached;
      goes = under_way && (aside() || goes_on(expanded));
    }
    if (goes) {
      expanded.result = Expansion::goes_on;
      return expanded;
    }
    if (expanded.result == Expansion::goal_reached) {
      begin_plan(expanded.last);
      return expanded;
    }
    if (expanded.result != Expansion::collision) {
      for (std::uint32_t back = derived().doomed_steps(); back-- > 0;) {
        if (!keep_recent(expanded.last, back)) expanded.result = Expansion::tree_full;
      }
    }
    tree_.end_expansion(expanded.last.expansion, expanded.last.step);
    if (expanded.result == Expansion::tree_full) finish(Status::tree_full);
    return expanded;
  }

  // Whether the expansion waits for what may end the way from its last state.
  bool aside() const { return braking() || shooting_; }

  Expansion take_turn(Expanded& expanded, const Watch& watch) {
    if (shooting_) return shoot(expanded, watch);
    return braking() ? brake(expanded, watch) : grow(expanded, watch);
  }

  // Whether the expansion continues after this step. Past max_steps it does in the open only, and while each step
  // decreases the distance to the target.
  bool goes_on(const Expanded& expanded) {
    const std::uint32_t steps = expanded.last.step;
    if (steps < parameters_.max_steps) return true;
    if (steps >= derived().open_steps() || expanded.crossed > kOpen) return false;
    const float before = apart_;
    apart_ = length(drive_.target().point - Vec2{drive_.state()[0], drive_.state()[1]});
    return apart_ < before;
  }

  // One step, and what becomes of it.
  Expansion grow(Expanded& expanded, const Watch& watch) {
    if (!take_step(drive_)) return Expansion::collision;
    watch(drive_.state(), drive_.next());
    drive_.go();
    ++statistics_.vertices;
    ++expanded.last.step;
    const Vec2 at{drive_.state()[0], drive_.state()[1]};
    const Index before = expanded.region;
    expanded.region = region_of(at, before);
    if (expanded.region != before) ++expanded.crossed;
    if (ending_.holds(drive_.state(), goal_depth_)) return Expansion::goal_reached;
    if (ending_.stops_inside(drive_.state(), check_.poses()[0])) {
      begin_braking(expanded.last);
      return Expansion::target_not_reached;
    }
    if (shoots() && expanded.last.step % LastMetres::kEvery == 0 && last_metres_.near(at)) {
      last_metres_.choose(check_.poses()[0]);
      if (begin_shot()) return Expansion::target_not_reached;
    }
    return settle(expanded);
  }

  // The next shot from the expansion's last state. False when there is none left.
  bool begin_shot() {
    check_.begin(drive_.state());
    shooting_ = last_metres_.next(check_.poses()[0]);
    if (shooting_) brake_.begin(drive_.state());
    shot_legs_ = 0;
    brake_steps_ = LastMetres::kHold;
    return shooting_;
  }

  // One step of a shot. Where none ends in the goal, the expansion goes on from where they began.
  Expansion shoot(Expanded& expanded, const Watch& watch) {
    const bool aimed = brake_steps_ < LastMetres::kHold || begin_shot_leg(expanded.last);
    if (aimed && take_step(brake_)) {
      watch(brake_.state(), brake_.next());
      brake_.go();
      ++statistics_.vertices;
      ++brake_steps_;
      return ending_.holds(brake_.state(), goal_depth_) ? end_braking() : Expansion::target_not_reached;
    }
    if (braking()) tree_.end_expansion(braking_, 0);
    braking_ = kNone;
    return begin_shot() ? Expansion::target_not_reached : settle(expanded);
  }

  // Each leg is an expansion of its own, which the tree has slots for.
  bool begin_shot_leg(Branch from) {
    const float* const state = brake_.state();
    Target target;
    const float speed = robot_.speed(state);
    const bool aims = last_metres_.aim(check_.poses()[0], speed, robot_.stopping_way(state), target);
    if (!aims || shot_legs_ == spare_expansions()) return false;
    const Index before = braking_;
    braking_ = tree_.begin_expansion(before == kNone ? from : Branch{before, brake_steps_}, target);
    if (before != kNone) tree_.end_expansion(before, brake_steps_);
    ++shot_legs_;
    brake_steps_ = 0;
    brake_.aim(tree_.target(braking_));
    return true;
  }

  // What becomes of an expansion whose last state does not end it in the goal.
  Expansion settle(const Expanded& expanded) {
    const Vec2 at{drive_.state()[0], drive_.state()[1]};
    remember(expanded.last.step, expanded.region);
    if (!keep_recent(expanded.last, derived().doomed_steps())) return Expansion::tree_full;
    const bool near = length(drive_.target().point - at) <= parameters_.near_radius * robot_length_;
    return near ? Expansion::target_reached : Expansion::target_not_reached;
  }

  bool braking() const { return braking_ != kNone; }

  // The brake is an expansion of its own, toward the same target, which the tree has a slot for.
  void begin_braking(Branch from) {
    Target target = drive_.target();
    target.speed = 0.0F;
    braking_ = tree_.begin_expansion(from, target);
    brake_steps_ = 0;
    brake_.begin(drive_.state());
    brake_.aim(tree_.target(braking_));
  }

  // One step of the brake. Where it cannot end in the goal, the expansion goes on from where the brake began.
  Expansion brake(const Expanded& expanded, const Watch& watch) {
    if (take_step(brake_)) {
      watch(brake_.state(), brake_.next());
      const float before = robot_.speed(brake_.state());
      brake_.go();
      ++statistics_.vertices;
      ++brake_steps_;
      const float* const state = brake_.state();
      if (ending_.holds(state, goal_depth_)) return end_braking();
      const bool slower = robot_.speed(state) < before;
      if (slower && !ending_.slow(state) && brake_steps_ < MotionTree::kMostSteps) return Expansion::target_not_reached;
    }
    tree_.end_expansion(braking_, 0);
    braking_ = kNone;
    check_.begin(drive_.state());
    return settle(expanded);
  }

  Expansion end_braking() {
    drive_.begin(brake_.state());
    return Expansion::goal_reached;
  }

  void remember(std::uint32_t step, Index region) {
    NewState& recent = recent_[step % kRecent];
    recent.region = region;
    for (int i = 0; i < robot_.state_size(); ++i) recent.state[i] = drive_.state()[i];
  }

  // Has the state `back` steps before the expansion's last kept, if there is one.
  bool keep_recent(Branch last, std::uint32_t back) {
    if (last.step <= back) return true;
    const std::uint32_t step = last.step - back;
    const NewState& recent = recent_[step % kRecent];
    return derived().keep(recent.region, {last.expansion, step}, recent.state);
  }

  // CONTROLLER, MOTION and COLLISION (lines 5 and 6). False when the step is not free or leaves the robot's limits.
  bool take_step(Drive& drive) { return ProvenStep(robot_, *scene_, parameters_, check_).take(drive); }

  // The region of a position; where no triangle contains it (a reference point outside the body may stand on an
  // obstacle), the last state's.
  Index region_of(Vec2 at, Index last) const {
    const Index triangle = locate(*scene_, at, last);
    return triangle == kNone ? last : regions_.region(triangle);
  }

  float tree_clearance() const { return parameters_.clearance + kTreeSlack * robot_length_; }

  void keep_for_tree() { check_.keep(tree_clearance(), longest_tree_step(robot_, parameters_.dt)); }

  // The way to `last`, and on by the brake if it brakes, has reached the goal. It is driven once more from the start,
  // expansion by expansion, as the plan's controls alone would drive the robot, and every step is proven again: what
  // holds is the plan. Until then the tree is used for nothing else. O(expansions of the way).
  void begin_plan(Branch last) {
    reached_ = last;
    const Branch end = braking() ? Branch{braking_, brake_steps_} : last;
    path_ = end.expansion == kNone ? kNone : tree_.turn_path(end);
    driven_ = path_;
    steps_left_ = 0;
    proof_.begin(robot_, *scene_, parameters_, check_, tree_.state(kRoot));
    if (driven_ == kNone) return finish_plan();
    proof_.place();
  }

  // At most max_steps steps of one expansion of the way.
  void drive_plan() {
    if (steps_left_ == 0) {
      proof_.aim(tree_.target(driven_));
      steps_left_ = tree_.steps(driven_);
    }
    for (std::uint32_t left = parameters_.max_steps; left > 0 && steps_left_ > 0; --left, --steps_left_) {
      if (!proof_.step()) return refuse_plan();
    }
    if (steps_left_ == 0) driven_ = tree_.next_of_path(driven_);
    if (driven_ == kNone) return finish_plan();
    proof_.keep();
  }

  // Ends the search as solved where the way that was driven ends in the goal; as internal where the tree beside it was
  // not the same as when it grew.
  void finish_plan() {
    const float* const end = proof_.state();
    for (int i = 0; i < robot_.state_size(); ++i) {
      if (proof_.tree_state()[i] == drive_.state()[i]) continue;
      finish(Status::internal);
      return;
    }
    const float depth = path_ == kNone ? 0.0F : proof_.end_depth(end_depth_);
    if (!ending_.holds(end, depth)) return refuse_plan();
    finish(Status::solved);
    note(proof_.measures());
  }

  void note(const PlanMeasures& measures) {
    statistics_.plan_steps = measures.steps;
    statistics_.plan_length = measures.length;
    statistics_.plan_duration = parameters_.dt * static_cast<float>(measures.steps);
    statistics_.plan_end_speed = robot_.speed(proof_.state());
    statistics_.hash = measures.hash;
  }

  // Goes on with the search; with its next try, since other ways to the goal would mostly begin as this one did.
  void refuse_plan() {
    ++statistics_.plans_refused;
    tree_.turn_path_back(path_);
    if (braking()) tree_.end_expansion(braking_, brake_steps_);
    braking_ = kNone;
    shooting_ = false;
    tree_.end_expansion(reached_.expansion, reached_.step);
    driven_ = kNone;
    keep_for_tree();
    restarts_.end_try();
  }

  void begin_to_improve() {
    improving_ = true;
    find_paths();
    const TargetGrid grid(scene_->bounds());
    const WayTools tools{robot_,  scene_, &parameters_, &check_,     &drive_,
                         &brake_, grid,   &ending_,     goal_depth_, tree_.state(kRoot)};
    improver_.begin(tools, proof_, regions_, found_path(), end_depth_, random_);
  }

  PlanPath found_path() const { return {tree_, path_}; }

  bool ready_ = false;
  std::uint32_t fingerprint_ = 0;                    // the scene's at init
  Failure failure_ = bad_argument(Argument::block);  // until init has one
  Arena arena_;
  MotionCheck check_;
  Ending ending_;
  float goal_depth_ = 0.0F;  // metres: how deep inside the goal the tree's ways end
  EndDepth end_depth_;       // and plans
  Restarts restarts_;
  Expanded expanded_{};       // the last expansion
  float apart_ = kInfinity;   // metres: how far the target of a long one was
  NewState recent_[kRecent];  // the last of the expansion
  Index root_region_ = kNone;
  Index path_ = kNone;    // the plan's first expansion
  Index driven_ = kNone;  // the expansion of the way to the goal that is driven next; kNone while the tree grows
  std::uint32_t steps_left_ = 0;  // of that expansion
  Branch reached_;                // the state of the way that reached the goal, or where it began to brake
  Index braking_ = kNone;         // the expansion that brakes for the goal; kNone: none does
  std::uint32_t brake_steps_ = 0;
  Drive brake_;
  bool shooting_ = false;        // whether the last metres are driven; braking_ is their last leg
  std::uint32_t shot_legs_ = 0;  // of this shot
  LastMetres last_metres_;
  PlanProof proof_;
  bool improving_ = false;  // since the first call of improve
  Improver improver_;
};

}  // namespace krait
