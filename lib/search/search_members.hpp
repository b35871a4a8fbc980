// SPDX-License-Identifier: Apache-2.0
// The members of Search, which each planner's file instantiates.
#pragma once

#include "krait/search/search.hpp"

namespace krait {

template <class Derived, class Guide>
std::uint64_t Search<Derived, Guide>::bytes_required(const Scene& scene, const Robot& robot, const Limits& limits) {
  Arena counting;
  Regions regions;
  MotionTree tree;
  Guide guide;
  Improver improver;
  MotionCheck check;
  float* recent = nullptr;
  take_pools(counting, scene, robot, limits, regions, tree, guide, improver);
  take_work(counting, robot, guide, check, recent);
  return counting.needed();
}

template <class Derived, class Guide>
Limits Search<Derived, Guide>::limits_for(std::uint64_t bytes, const Scene& scene, const Robot& robot,
                                          std::uint32_t way_legs) {
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

template <class Derived, class Guide>
Failure Search<Derived, Guide>::init(void* block, std::uint64_t bytes, const Scene& scene, const Robot& robot,
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
  take_work(arena_, robot, guide_, check_, recent_);
  statistics_ = {};
  ready_ = true;
  failure_ = {Status::ready};
  return {};
}

template <class Derived, class Guide>
Status Search<Derived, Guide>::start(const Query& query) {
  if (!ready_) return status();
  if (scene_->fingerprint() != fingerprint_) return scene_changed();
  derived().reset_guide();
  restarts_.begin(derived().restart_unit());
  return begin(query);
}

template <class Derived, class Guide>
Status Search<Derived, Guide>::advance(std::uint64_t iterations, const Watch& watch) {
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

template <class Derived, class Guide>
Status Search<Derived, Guide>::improve(std::uint64_t iterations) {
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

template <class Derived, class Guide>
Contact Search<Derived, Guide>::contact() {
  if (status() != Status::start_in_collision) return {};
  Contact contact = check_.contact(drive_.state());
  if (contact.with == Hindrance::none) contact = {.with = Hindrance::ground, .at = start_position()};
  return contact;
}

template <class Derived, class Guide>
Bottleneck Search<Derived, Guide>::bottleneck() {
  const Status ended = status();
  if (ended == Status::no_route) {
    const Bottleneck bottleneck = bottleneck_for(body_disc());
    return bottleneck.width < bottleneck.needed ? bottleneck : bottleneck_for(position_disc());
  }
  const bool in_vain = ended == Status::budget_used || ended == Status::tree_full || ended == Status::time_used;
  return in_vain ? bottleneck_for(body_disc()) : Bottleneck{};
}

template <class Derived, class Guide>
void Search<Derived, Guide>::stop_for_time() {
  if (status() == Status::searching) finish(Status::time_used);
}

template <class Derived, class Guide>
Plan Search<Derived, Guide>::plan() const {
  if (status() != Status::solved) return {};
  return {robot_, improving_ ? improver_.plan() : found_path(), tree_.state(kRoot), parameters_.dt};
}

template <class Derived, class Guide>
Statistics Search<Derived, Guide>::statistics() const {
  Statistics result = statistics_;
  result.collision_checks = check_.checks();
  if (ready_) {
    result.bytes_given = arena_.bytes();
    result.bytes_used = arena_.needed() - tree_.bytes_untouched();
  }
  return result;
}

template <class Derived, class Guide>
typename Search<Derived, Guide>::Expanded Search<Derived, Guide>::expand(Index vertex, Index region,
                                                                         const Target& toward, const Watch& watch) {
  const Index expansion = tree_.begin_expansion(tree_.branch(vertex), toward);
  drive_.begin(tree_.state(vertex));
  check_.begin(drive_.state());
  drive_.aim(tree_.target(expansion));
  watch.expands(vertex, drive_.target());
  expanded_ = {Expansion::target_not_reached, region, {expansion, 0}};
  apart_ = kInfinity;
  return drive(expanded_, watch);
}

template <class Derived, class Guide>
typename Search<Derived, Guide>::Expanded Search<Derived, Guide>::go_on(const Watch& watch) {
  restarts_.uncount();
  return drive(expanded_, watch);
}

template <class Derived, class Guide>
Target Search<Derived, Guide>::any_way_to(Vec2 point, std::uint32_t tries) {
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

template <class Derived, class Guide>
void Search<Derived, Guide>::slow_for(Target& target, Index from) const {
  if (!ending_.limits_speed()) return;
  const float way = absolute(robot_.stopping_way(tree_.state(from)));
  const float distance = length(target.point - position(from));
  if (distance < way) target.speed = target.speed * std::sqrt(distance / way);
}

template <class Derived, class Guide>
Vec2 Search<Derived, Guide>::random_point_in_bounds() {
  const Box bounds = scene_->bounds();
  const float u = random_.unit();
  const float v = random_.unit();
  return {bounds.min.x + u * (bounds.max.x - bounds.min.x), bounds.min.y + v * (bounds.max.y - bounds.min.y)};
}

template <class Derived, class Guide>
Status Search<Derived, Guide>::finish(Status status) {
  failure_ = {status};
  return status;
}

template <class Derived, class Guide>
Failure Search<Derived, Guide>::bad_argument(Argument argument) {
  return {Status::bad_argument, 0, static_cast<std::uint32_t>(argument)};
}

template <class Derived, class Guide>
Status Search<Derived, Guide>::scene_changed() {
  failure_ = {Status::bad_scene, Scene::kHeaderSection, offsetof(format::Header, crc32)};
  return status();
}

template <class Derived, class Guide>
void Search<Derived, Guide>::take_pools(Arena& arena, const Scene& scene, const Robot& robot, const Limits& limits,
                                        Regions& regions, MotionTree& tree, Guide& guide, Improver& improver) {
  regions.take(arena, scene);
  tree.take(arena, limits.vertices, limits.kept_expansions(), robot.state_size());
  guide.take(arena, scene, limits.vertices);
  if (limits.way_legs > 0) improver.take(arena, limits.way_legs, robot.state_size());
}

template <class Derived, class Guide>
void Search<Derived, Guide>::take_work(Arena& arena, const Robot& robot, Guide& guide, MotionCheck& check,
                                       float*& recent) {
  check.take(arena, robot);
  if constexpr (requires { guide.take_work(arena, robot); }) guide.take_work(arena, robot);
  recent = arena.take<float>(Pool::work, std::uint64_t{kRecent} * static_cast<std::uint32_t>(robot.state_size()));
}

template <class Derived, class Guide>
Failure Search<Derived, Guide>::check_setup(const Robot& robot, const Scene& scene, const Parameters& parameters,
                                            const Limits& limits) {
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

template <class Derived, class Guide>
Status Search<Derived, Guide>::begin(const Query& query) {
  statistics_ = {};
  improving_ = false;
  driven_ = kNone;
  braking_ = kNone;
  shooting_ = false;
  random_ = Random(query.seed);
  check_.assign(robot_, *scene_, tree_clearance(), static_cast<int>(parameters_.max_substeps), !parameters_.plain);
  keep_for_tree();
  ending_.assign(robot_, *scene_, query.goal, derived().end_speed());
  tree_.reset(scene_->bounds(), spare_expansions());
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

template <class Derived, class Guide>
std::uint32_t Search<Derived, Guide>::spare_expansions() const {
  if (!shoots()) return ending_.limits_speed() ? 1 : 0;
  const std::uint32_t half = limits_.kept_expansions() / 2;
  return half < LastMetres::kMostLegs ? half : LastMetres::kMostLegs;
}

template <class Derived, class Guide>
Nimbleness Search<Derived, Guide>::nimbleness() const {
  const Robot& robot = robot_;
  return {robot_length_,
          robot.turning_radius(robot_length_),
          robot.top_speed(robot_length_),
          inner_radius(robot.body(0), {}),
          robot.reversible() && robot.body_count() == 1,
          parameters_.dt};
}

template <class Derived, class Guide>
bool Search<Derived, Guide>::find_paths() {
  ++statistics_.dijkstra_runs;
  return regions_.reset(ending_.goal(), least_portal_width(), kLeastCost * robot_length_);
}

template <class Derived, class Guide>
void Search<Derived, Guide>::begin_anew() {
  ++statistics_.restarts;
  drive_.begin(tree_.state(kRoot));
  tree_.clear();
  braking_ = kNone;
  shooting_ = false;
  derived().reset_guide();
  find_paths();
  derived().keep(root_region_, {}, drive_.state());
}

template <class Derived, class Guide>
Failure Search<Derived, Guide>::check_query(const Query& query) {
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

template <class Derived, class Guide>
Status Search<Derived, Guide>::plant(bool fits) {
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

template <class Derived, class Guide>
typename Search<Derived, Guide>::InnerDisc Search<Derived, Guide>::body_disc() {
  const Polygon body = robot_.body(0);
  const Vec2 center = middle(body);
  check_.begin(drive_.state());
  const Pose& pose = check_.poses()[0];
  const float radius = inner_radius(body, center) + parameters_.clearance;
  return {pose.position + turned(pose.heading, center), radius, length(center) + kReachRounding};
}

template <class Derived, class Guide>
typename Search<Derived, Guide>::InnerDisc Search<Derived, Guide>::position_disc() const {
  return {start_position(), inner_radius(robot_.body(0), {}) + parameters_.clearance, 0.0F};
}

template <class Derived, class Guide>
float Search<Derived, Guide>::least_portal_width() const {
  const float inner = inner_radius(robot_.body(0), {});
  return parameters_.prune_portals && inner > 0.0F ? 2.0F * (inner + parameters_.clearance) : 0.0F;
}

template <class Derived, class Guide>
bool Search<Derived, Guide>::body_fits() {
  const InnerDisc disc = body_disc();
  if (!room_at_goal(position_disc()).enough || !room_at_goal(disc).enough) return false;
  const Index triangle = locate(*scene_, disc.at);
  return triangle == kNone || regions_.connected(triangle, ending_.goal(), disc.reach, 2.0F * disc.radius);
}

template <class Derived, class Guide>
GoalRoom Search<Derived, Guide>::room_at_goal(const InnerDisc& disc) const {
  const Obstacles obstacles(*scene_, 0.0F);
  return goal_room(*scene_, obstacles, ending_.goal(), disc.reach, disc.radius - 2.0F * obstacles.margin());
}

template <class Derived, class Guide>
Bottleneck Search<Derived, Guide>::bottleneck_for(const InnerDisc& disc) {
  const float needed = 2.0F * disc.radius;
  const GoalRoom room = room_at_goal(disc);
  if (!room.enough) return {2.0F * room.found, needed, room.at, true};
  const Index triangle = locate(*scene_, disc.at);
  if (triangle == kNone) return {};
  Bottleneck bottleneck = regions_.widest_way(triangle, disc.reach);
  bottleneck.needed = needed;
  return bottleneck;
}

template <class Derived, class Guide>
typename Search<Derived, Guide>::Expanded Search<Derived, Guide>::drive(Expanded& expanded, const Watch& watch) {
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

template <class Derived, class Guide>
typename Search<Derived, Guide>::Expansion Search<Derived, Guide>::take_turn(Expanded& expanded, const Watch& watch) {
  if (shooting_) return shoot(expanded, watch);
  return braking() ? brake(expanded, watch) : grow(expanded, watch);
}

template <class Derived, class Guide>
bool Search<Derived, Guide>::goes_on(const Expanded& expanded) {
  const std::uint32_t steps = expanded.last.step;
  if (steps < parameters_.max_steps) return true;
  if (steps >= derived().open_steps() || expanded.crossed > kOpen) return false;
  const float before = apart_;
  apart_ = length(drive_.target().point - Vec2{drive_.state()[0], drive_.state()[1]});
  return apart_ < before;
}

template <class Derived, class Guide>
typename Search<Derived, Guide>::Expansion Search<Derived, Guide>::grow(Expanded& expanded, const Watch& watch) {
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

template <class Derived, class Guide>
bool Search<Derived, Guide>::begin_shot() {
  check_.begin(drive_.state());
  shooting_ = last_metres_.next(check_.poses()[0]);
  if (shooting_) brake_.begin(drive_.state());
  shot_legs_ = 0;
  brake_steps_ = LastMetres::kHold;
  return shooting_;
}

template <class Derived, class Guide>
typename Search<Derived, Guide>::Expansion Search<Derived, Guide>::shoot(Expanded& expanded, const Watch& watch) {
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

template <class Derived, class Guide>
bool Search<Derived, Guide>::begin_shot_leg(Branch from) {
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

template <class Derived, class Guide>
typename Search<Derived, Guide>::Expansion Search<Derived, Guide>::settle(const Expanded& expanded) {
  const Vec2 at{drive_.state()[0], drive_.state()[1]};
  remember(expanded.last.step, expanded.region);
  if (!keep_recent(expanded.last, derived().doomed_steps())) return Expansion::tree_full;
  const bool near = length(drive_.target().point - at) <= parameters_.near_radius * robot_length_;
  return near ? Expansion::target_reached : Expansion::target_not_reached;
}

template <class Derived, class Guide>
void Search<Derived, Guide>::begin_braking(Branch from) {
  Target target = drive_.target();
  target.speed = 0.0F;
  braking_ = tree_.begin_expansion(from, target);
  brake_steps_ = 0;
  brake_.begin(drive_.state());
  brake_.aim(tree_.target(braking_));
}

template <class Derived, class Guide>
typename Search<Derived, Guide>::Expansion Search<Derived, Guide>::brake(const Expanded& expanded, const Watch& watch) {
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

template <class Derived, class Guide>
typename Search<Derived, Guide>::Expansion Search<Derived, Guide>::end_braking() {
  drive_.begin(brake_.state());
  return Expansion::goal_reached;
}

template <class Derived, class Guide>
void Search<Derived, Guide>::remember(std::uint32_t step, Index region) {
  recent_regions_[step % kRecent] = region;
  const float* const state = drive_.state();
  float* const copy = recent(step);
  const int size = robot_.state_size();
  for (int i = 0; i < size; ++i) copy[i] = state[i];
}

template <class Derived, class Guide>
bool Search<Derived, Guide>::keep_recent(Branch last, std::uint32_t back) {
  if (last.step <= back) return true;
  const std::uint32_t step = last.step - back;
  return derived().keep(recent_regions_[step % kRecent], {last.expansion, step}, recent(step));
}

template <class Derived, class Guide>
Index Search<Derived, Guide>::region_of(Vec2 at, Index last) const {
  const Index triangle = locate(*scene_, at, last);
  return triangle == kNone ? last : regions_.region(triangle);
}

template <class Derived, class Guide>
void Search<Derived, Guide>::begin_plan(Branch last) {
  reached_ = last;
  const Branch end = braking() ? Branch{braking_, brake_steps_} : last;
  path_ = end.expansion == kNone ? kNone : tree_.turn_path(end);
  driven_ = path_;
  steps_left_ = 0;
  proof_.begin(robot_, *scene_, parameters_, check_, tree_.state(kRoot));
  if (driven_ == kNone) return finish_plan();
  proof_.place();
}

template <class Derived, class Guide>
void Search<Derived, Guide>::drive_plan() {
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

template <class Derived, class Guide>
void Search<Derived, Guide>::finish_plan() {
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

template <class Derived, class Guide>
void Search<Derived, Guide>::note(const PlanMeasures& measures) {
  statistics_.plan_steps = measures.steps;
  statistics_.plan_length = measures.length;
  statistics_.plan_duration = parameters_.dt * static_cast<float>(measures.steps);
  statistics_.plan_end_speed = robot_.speed(proof_.state());
  statistics_.hash = measures.hash;
}

template <class Derived, class Guide>
void Search<Derived, Guide>::refuse_plan() {
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

template <class Derived, class Guide>
void Search<Derived, Guide>::begin_to_improve() {
  improving_ = true;
  find_paths();
  const TargetGrid grid(scene_->bounds());
  const WayTools tools{robot_,  scene_, &parameters_, &check_,     &drive_,
                       &brake_, grid,   &ending_,     goal_depth_, tree_.state(kRoot)};
  improver_.begin(tools, proof_, regions_, found_path(), end_depth_, random_);
}

}  // namespace krait
