// SPDX-License-Identifier: Apache-2.0
#include "search/search.hpp"

#include <algorithm>

#include "decomposition/locate.hpp"
#include "krait/geometry.hpp"
#include "robot/shape.hpp"

namespace krait::detail {

// The block.

void Search::count(Arena& counting, const Scene& scene, const Robot& robot, const Limits& limits) {
  Regions regions;
  MotionTree tree;
  Improver improver;
  MotionCheck check;
  RecentStates recent;
  take_pools(counting, scene, robot, limits, regions, tree, improver, check, recent);
}

void Search::take_pools(Arena& arena, const Scene& scene, const Robot& robot, const Limits& limits, Regions& regions,
                        MotionTree& tree, Improver& improver, MotionCheck& check, RecentStates& recent) {
  regions.allocate(arena, scene);
  tree.allocate(arena, limits.vertices, limits.kept_expansions(), robot.state_size());
  if (limits.way_legs > 0) improver.allocate(arena, limits.way_legs, robot.state_size());
  check.allocate(arena, robot);
  recent.allocate(arena, robot);
}

Failure Search::check_setup(const Setup& setup, const Parameters& parameters, const Limits& limits) {
  ready_ = false;
  robot_ = setup.robot;
  scene_ = setup.scene;
  parameters_ = parameters;
  limits_ = limits;
  if (!math::exact_arithmetic() || !robot_.exact()) return failure_ = {Status::bad_arithmetic};
  if (scene_ == nullptr || scene_->bytes() == 0) return failure_ = bad_argument(Argument::scene);
  const Argument bad_robot = first_bad_of_robot(robot_);
  if (bad_robot != Argument::none) return failure_ = {Status::bad_robot, 0, static_cast<std::uint32_t>(bad_robot)};
  Argument bad = parameters.first_bad();
  if (bad == Argument::none) bad = limits.first_bad();
  if (bad != Argument::none) return failure_ = bad_argument(bad);
  if (!can_integrate(robot_, parameters.dt)) {
    failure_ = bad_argument(Argument::dt);
    failure_.most = longest_time_step(robot_, parameters.dt);
    return failure_;
  }
  robot_length_ = detail::robot_length(robot_);
  return failure_ = {};
}

static_assert(Setup::kAlignment == Arena::kAlignment);

Failure Search::take_block(void* block, std::uint64_t bytes, std::uint64_t needed) {
  if (bytes < needed) return failure_ = {Status::arena_too_small, 0, 0, needed};
  const bool usable = block != nullptr && reinterpret_cast<std::uintptr_t>(block) % Setup::kAlignment == 0;
  if (!usable) return failure_ = bad_argument(Argument::block);
  fingerprint_ = scene_->fingerprint();
  arena_ = Arena(block, bytes);
  RecentStates recent;
  take_pools(arena_, *scene_, robot_, limits_, regions_, tree_, improver_, check_, recent);
  expander_.set_up(robot_, parameters_.dt, recent);
  statistics_ = {};
  ready_ = true;
  failure_ = {Status::ready};
  return {};
}

Failure Search::bad_argument(Argument argument) {
  return {Status::bad_argument, 0, static_cast<std::uint32_t>(argument)};
}

// The query.

bool Search::usable() {
  if (!ready_) return false;
  if (scene_->fingerprint() == fingerprint_) return true;
  failure_ = {Status::bad_scene, Scene::kHeaderSection, offsetof(format::Header, crc32)};
  return false;
}

Status Search::begin(const Query& query, const Keeper& keeper) {
  keeper_ = keeper;
  statistics_ = {};
  improving_ = false;
  driven_ = kNone;
  random_ = Random(query.seed);
  check_.assign(robot_, *scene_, tree_clearance(), static_cast<int>(parameters_.tuning.max_substeps), shortcuts_);
  keep_for_tree();
  expander_.reset();
  ending_.assign(robot_, *scene_, query.goal, parameters_.end_speed);
  tree_.reset(scene_->bounds(), spare_expansions());
  failure_ = check_query(query);
  if (status() != Status::searching) return status();
  const float deepest = query.goal.deepest(*scene_);
  goal_depth_ = std::min(deepest, parameters_.goal_margin);
  end_depth_ = {kDepthKept * goal_depth_, deepest};
  equip_expander(keeper);
  const bool fits = !parameters_.tuning.prune_portals || disc_route().fits();
  if (find_paths()) {
    add_root(fits);
  } else {
    finish(Status::goal_in_obstacle);
  }
  return status();
}

Failure Search::check_query(const Query& query) {
  if (query.start == nullptr) return bad_argument(Argument::start);
  for (int i = 0; i < robot_.state_size(); ++i) {
    if (!finite(query.start[i])) return bad_argument(Argument::start);
  }
  expander_.place(query.start);
  if (!ending_.goal().valid(*scene_)) return bad_argument(Argument::goal);
  if (!scene_->inside_bounds({query.start[0], query.start[1]})) return {Status::start_outside};
  if (!robot_.within_limits(query.start)) return bad_argument(Argument::start);
  if (!check_.free(query.start)) return {Status::start_in_collision};
  return {Status::searching};
}

std::uint32_t Search::spare_expansions() const {
  if (!shoots()) return ending_.limits_speed() ? 1 : 0;
  const std::uint32_t half = limits_.kept_expansions() / 2;
  return std::min(LastMetres::kMostLegs, half);
}

void Search::equip_expander(const Keeper& keeper) {
  ExpanderTools tools;
  tools.robot = robot_;
  tools.scene = scene_;
  tools.parameters = &parameters_;
  tools.regions = &regions_;
  tools.tree = &tree_;
  tools.check = &check_;
  tools.ending = &ending_;
  tools.statistics = &statistics_;
  tools.keeper = keeper;
  tools.robot_length = robot_length_;
  tools.goal_depth = goal_depth_;
  tools.shoots = shoots();
  tools.spare_expansions = spare_expansions();
  expander_.assign(tools);
}

bool Search::find_paths() {
  ++statistics_.dijkstra_runs;
  const float width = parameters_.tuning.prune_portals ? least_portal_width(robot_, parameters_.clearance) : 0.0F;
  return regions_.reset(ending_.goal(), width, kLeastCost * robot_length_);
}

void Search::add_root(bool fits) {
  const Index triangle = locate(*scene_, start_position());
  if (triangle == kNone) return finish(Status::start_in_collision);
  root_region_ = regions_.region(triangle);
  statistics_.vertices = 1;
  if (regions_.cost(root_region_) == kInfinity) return finish(Status::no_route);
  keep_root();
  begin_tries();
  finish(fits ? Status::searching : Status::no_route);
  const float depth = std::min(end_depth_.most, kStartDepth);
  if (ending_.holds(expander_.state(), depth)) begin_plan({});
}

DiscRoute Search::disc_route() {
  check_.begin(expander_.state());
  const Pose& body = check_.poses()[0];
  return {robot_, regions_, ending_.goal(), goal_depth_, parameters_.clearance, start_position(), body};
}

// The search.

bool Search::count_expansion() {
  if (statistics_.iterations == limits_.iterations) {
    finish(Status::budget_used);
    return false;
  }
  ++statistics_.iterations;
  return true;
}

void Search::begin_tries() {
  const auto regions = static_cast<float>(regions_.regions_ahead(root_region_, scene_->triangle_count()));
  const float way = regions / kUnitRegions;
  restarts_.begin(parameters_.tuning.restart_unit, math::clamp(way * way, kShortestTry, 1.0F + way));
}

void Search::new_try() {
  ++statistics_.restarts;
  expander_.place(tree_.state(kRoot));
  expander_.reset();
  tree_.clear();
  find_paths();
  keep_root();
}

Expanded Search::expand(Index vertex, Index region, const Target& toward, const Watch& watch) {
  return finish_expansion(expander_.expand(vertex, region, toward, watch));
}

Expanded Search::continue_expansion(const Watch& watch) {
  restarts_.uncount();
  return finish_expansion(expander_.continue_expansion(watch));
}

Expanded Search::finish_expansion(const Expanded& expanded) {
  if (expanded.outcome == Outcome::goal_reached) begin_plan(expander_.end());
  if (expanded.outcome == Outcome::tree_full) finish(Status::tree_full);
  return expanded;
}

Target Search::any_way_to(Vec2 point, std::uint32_t tries) {
  constexpr float kGentlest = 0.15F;  // of the sharpest turn; measured: bench/ABLATIONS.md, "Constants"
  Target target;
  target.point = point;
  const auto patience = static_cast<float>(tries) / static_cast<float>(tries + kPatience);
  const bool backward = robot_.reversible() && random_.unit() < parameters_.tuning.reverse_share * patience;
  const float slowest = parameters_.tuning.slowest;
  const float share = slowest + (1.0F - slowest) * random_.unit();
  target.speed = backward ? -share : share;
  if (random_.unit() < parameters_.tuning.gentle_share * patience) {
    target.turn = kGentlest + (1.0F - kGentlest) * random_.unit();
  }
  return target;
}

void Search::slow_for(Target& target, Index from, bool in_goal) const {
  const float at_goal = ending_.limits_speed() ? 1.0F : 0.0F;
  const float ways = in_goal ? at_goal : parameters_.tuning.stopping_ways;
  if (!robot_.has_speed()) return;
  const float* state = tree_.state(from);
  const float way = ways * math::absolute(robot_.stopping_way(state));
  const float distance = length(target.point - position(from));
  if (distance >= way) return;
  const float share = robot_.speed(state) / robot_.top_speed(robot_length_);
  target.speed = target.speed * (share < 1.0F ? share : 1.0F) * std::sqrt(distance / way);
}

Vec2 Search::random_point_in_bounds() {
  const Box bounds = scene_->bounds();
  const float u = random_.unit();
  const float v = random_.unit();
  return {bounds.min.x + u * (bounds.max.x - bounds.min.x), bounds.min.y + v * (bounds.max.y - bounds.min.y)};
}

// The plan.

void Search::begin_plan(Branch end) {
  path_ = end.expansion == kNone ? kNone : tree_.turn_path(end);
  driven_ = path_;
  steps_remaining_ = 0;
  proof_.begin(robot_, *scene_, parameters_, check_, tree_.state(kRoot));
  if (driven_ == kNone) return finish_plan();
  proof_.place();
}

void Search::drive_plan() {
  if (steps_remaining_ == 0) {
    proof_.aim(tree_.target(driven_));
    steps_remaining_ = tree_.steps(driven_);
  }
  for (std::uint32_t remaining = parameters_.tuning.max_steps; remaining > 0 && steps_remaining_ > 0;
       --remaining, --steps_remaining_) {
    if (!proof_.step()) return refuse_plan();
  }
  if (steps_remaining_ == 0) driven_ = tree_.next_of_path(driven_);
  if (driven_ == kNone) return finish_plan();
  proof_.keep();
}

void Search::finish_plan() {
  const float* const end = proof_.state();
  for (int i = 0; i < robot_.state_size(); ++i) {
    if (proof_.tree_state()[i] == expander_.state()[i]) continue;
    finish(Status::internal);
    return;
  }
  const float depth = path_ == kNone ? 0.0F : proof_.end_depth(end_depth_);
  if (!ending_.holds(end, depth)) return refuse_plan();
  finish(Status::solved);
  record(proof_.measures());
}

void Search::record(const PlanMeasures& measures) {
  statistics_.plan_steps = measures.steps;
  statistics_.plan_length = measures.length;
  statistics_.plan_duration = parameters_.dt * static_cast<float>(measures.steps);
  statistics_.plan_end_speed = robot_.speed(proof_.state());
  statistics_.hash = measures.hash;
}

void Search::refuse_plan() {
  ++statistics_.plans_refused;
  tree_.turn_path_back(path_);
  expander_.refuse();
  driven_ = kNone;
  keep_for_tree();
  restarts_.end_try();
}

void Search::begin_to_improve(bool restarts) {
  improving_ = true;
  restarted_goes_on_ = false;
  find_paths();
  const TargetGrid grid(scene_->bounds());
  LastMetres* const last_metres = shoots() ? &expander_.last_metres() : nullptr;
  const WayTools tools{robot_, scene_,   &parameters_, &check_,     &expander_.drive(), &expander_.brake(),
                       grid,   &ending_, last_metres,  goal_depth_, tree_.state(kRoot)};
  improver_.begin(tools, proof_, regions_, found_path(), end_depth_, random_, restarts);
  random_ = Random(random_.bits());  // restarted searches draw other numbers than the improver
}

void Search::improve_along_line() {
  if (!improver_.iterate()) return;
  ++statistics_.improvements;
  record(improver_.measures());
}

bool Search::resume_restarted() {
  finish(Status::searching);
  return restarted_goes_on_;
}

void Search::begin_restarted() {
  new_try();
  begin_tries();
  keep_for_tree();
}

void Search::pause_restarted() {
  const bool goes_on = status() == Status::searching && !(driving() && !improver_.is_better(found_path()));
  if (status() == Status::internal) return;
  if (status() == Status::solved) {
    improver_.take_found(found_path());
    ++statistics_.improvements;
  }
  finish(Status::solved);
  restarted_goes_on_ = goes_on;
  if (goes_on) return;
  driven_ = kNone;
  if (!improver_.searches_next()) find_paths();  // which the next search would do once more
  improver_.search_over();
}

// Answers.

void Search::finish(Status status) { failure_ = {status}; }

void Search::stop_for_time() {
  if (status() == Status::searching) finish(Status::time_used);
}

Plan Search::plan() const {
  if (status() != Status::solved) return {};
  return {robot_, improving_ ? improver_.plan() : found_path(), tree_.state(kRoot), parameters_.dt};
}

Statistics Search::statistics() const {
  Statistics result = statistics_;
  result.collision_checks = check_.checks();
  if (ready_) {
    result.bytes_given = arena_.bytes();
    result.bytes_used = arena_.needed() - tree_.bytes_untouched();
  }
  return result;
}

Contact Search::contact() {
  if (status() != Status::start_in_collision) return {};
  Contact contact = check_.contact(expander_.state());
  if (contact.kind == ContactKind::none) contact = {.kind = ContactKind::ground, .at = start_position()};
  return contact;
}

Bottleneck Search::bottleneck() {
  const Status ended = status();
  const bool in_vain = ended == Status::budget_used || ended == Status::tree_full || ended == Status::time_used;
  if (!in_vain && ended != Status::no_route) return {};
  if (in_vain) expander_.place(tree_.state(kRoot));
  return disc_route().narrowest(ended == Status::no_route);
}

}  // namespace krait::detail
