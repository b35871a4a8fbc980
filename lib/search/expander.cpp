// SPDX-License-Identifier: Apache-2.0
#include "search/expander.hpp"

#include "decomposition/locate.hpp"
#include "plan/proven_step.hpp"
#include "robot/shape.hpp"

namespace krait::detail {
namespace {

Nimbleness nimbleness(const Robot& robot, float length, const Parameters& parameters) {
  const bool alone = robot.body_count() == 1;
  const float radius = robot.turning_radius(length);
  const int pushed = robot.docking() != nullptr && radius > 0.0F ? robot.backing_body() : 0;
  const bool backward = robot.reversible() && (alone || pushed > 0);
  const Polygon outline = robot.body(0);
  return {length,
          length * static_cast<float>(robot.body_count()),
          radius,
          robot.top_speed(length),
          inner_radius(outline, {}),
          farthest(outline.vertices, outline.count),
          backward,
          pushed,
          parameters.dt,
          parameters.clearance + kTreeSlack * length,
          outline,
          backward && alone && radius > 0.0F ? robot.parking() : nullptr,
          backward && pushed > 0 ? robot.docking() : nullptr};
}

}  // namespace

void Expander::set_up(const Robot& robot, float dt, const RecentStates& recent) {
  drive_.assign(robot, dt);
  brake_.assign(robot, dt);
  recent_ = recent;
}

void Expander::assign(const ExpanderTools& tools) {
  tools_ = tools;
  if (!tools.shoots && tools.robot.departing() == nullptr) return;
  const Nimbleness robot = nimbleness(tools.robot, tools.robot_length, *tools.parameters);
  last_metres_.assign(*tools.scene, tools.ending->goal(), robot);
}

void Expander::reset() {
  braking_ = kNone;
  shooting_ = false;
}

Expanded Expander::expand(Index vertex, Index region, const Target& toward, const Watch& watch) {
  MotionTree& tree = *tools_.tree;
  const Index expansion = tree.begin_expansion(tree.branch(vertex), toward);
  drive_.begin(tree.state(vertex));
  tools_.check->begin(drive_.state());
  drive_.aim(tree.target(expansion));
  watch.expands(vertex, drive_.target());
  expanded_ = {Outcome::target_not_reached, region, {expansion, 0}};
  near_ = near(drive_.target().point);
  apart_ = kInfinity;
  return continue_expansion(watch);
}

float Expander::near(Vec2 target) const {
  const SearchTuning& tuning = tools_.parameters->tuning;
  const bool in_goal = tools_.ending->goal().contains(*tools_.scene, target, 0.0F);
  return (in_goal ? tuning.goal_near_radius : tuning.near_radius) * tools_.robot_length;
}

float Expander::target_distance() const {
  const Target& target = drive_.target();
  const int leader = target.speed < 0.0F ? tools_.robot.backing_body() : 0;
  return length(target.point - tools_.check->poses()[leader].position);
}

Expanded Expander::continue_expansion(const Watch& watch) {
  bool goes = true;
  for (std::uint32_t remaining = tools_.parameters->tuning.max_steps; goes && remaining > 0; --remaining) {
    expanded_.outcome = take_turn(watch);
    goes = expanded_.outcome == Outcome::target_not_reached && (waits() || continues());
  }
  if (goes) expanded_.outcome = Outcome::goes_on;
  if (goes || expanded_.outcome == Outcome::goal_reached) return expanded_;
  if (expanded_.outcome != Outcome::collision) {
    for (std::uint32_t back = tools_.parameters->tuning.doomed_steps; back-- > 0;) {
      if (!keep_recent(back)) expanded_.outcome = Outcome::tree_full;
    }
  }
  tools_.tree->end_expansion(expanded_.last.expansion, expanded_.last.step);
  return expanded_;
}

void Expander::begin_legs() {
  drive_.begin(tools_.tree->state(kRoot));
  tools_.check->begin(drive_.state());
  expanded_ = {Outcome::target_not_reached, region_of(position(), kNone), {}};
}

bool Expander::begin_leg(const Target& target) {
  MotionTree& tree = *tools_.tree;
  if (tree.expansions_full()) return false;
  const Branch before = expanded_.last;
  expanded_.last = {tree.begin_expansion(before, target), 0};
  if (before.expansion != kNone) tree.end_expansion(before.expansion, before.step);
  drive_.aim(tree.target(expanded_.last.expansion));
  return true;
}

Outcome Expander::take_leg_step(bool keeps, const Watch& watch) {
  if (!take_step(drive_, watch)) return Outcome::collision;
  ++expanded_.last.step;
  expanded_.region = region_of(position(), expanded_.region);
  if (tools_.ending->holds(drive_.state(), tools_.goal_depth)) return Outcome::goal_reached;
  const bool full = keeps && !tools_.keeper(expanded_.region, expanded_.last, drive_.state());
  return full ? Outcome::tree_full : Outcome::target_not_reached;
}

const Expanded& Expander::end_legs(Outcome outcome) {
  expanded_.outcome = outcome;
  const Branch last = expanded_.last;
  const bool needed = outcome == Outcome::goes_on || outcome == Outcome::goal_reached;
  if (last.expansion != kNone && !needed) tools_.tree->end_expansion(last.expansion, last.step);
  return expanded_;
}

void Expander::refuse() {
  if (braking()) tools_.tree->end_expansion(braking_, brake_steps_);
  reset();
  tools_.tree->end_expansion(expanded_.last.expansion, expanded_.last.step);
}

Outcome Expander::take_turn(const Watch& watch) {
  if (shooting_) return shoot(watch);
  return braking() ? take_brake_step(watch) : grow(watch);
}

bool Expander::continues() {
  const std::uint32_t steps = expanded_.last.step;
  if (steps < tools_.parameters->tuning.max_steps) return true;
  if (steps >= tools_.parameters->tuning.open_steps || expanded_.crossed > kOpen) return false;
  const float before = apart_;
  apart_ = target_distance();
  return apart_ < before;
}

Outcome Expander::grow(const Watch& watch) {
  if (!take_step(drive_, watch)) return Outcome::collision;
  ++expanded_.last.step;
  const Index before = expanded_.region;
  expanded_.region = region_of(position(), before);
  if (expanded_.region != before) ++expanded_.crossed;
  const Ending& ending = *tools_.ending;
  const Pose* const poses = tools_.check->poses();
  if (ending.holds(drive_.state(), tools_.goal_depth)) return Outcome::goal_reached;
  if (ending.stops_inside(drive_.state(), poses[0])) {
    begin_braking();
    return Outcome::target_not_reached;
  }
  if (tools_.shoots && expanded_.last.step % LastMetres::kEvery == 0 && last_metres_.near(position())) {
    last_metres_.choose(poses);
    if (begin_shot()) return Outcome::target_not_reached;
  }
  return end_step();
}

bool Expander::begin_shot() {
  tools_.check->begin(drive_.state());
  shooting_ = last_metres_.next(tools_.check->poses());
  if (shooting_) brake_.begin(drive_.state());
  shot_legs_ = 0;
  brake_steps_ = LastMetres::kLongest;
  return shooting_;
}

Outcome Expander::shoot(const Watch& watch) {
  const Moment now{tools_.robot, brake_.state(), tools_.check->poses()};
  const bool aimed = !last_metres_.leg_over(brake_steps_, now) || begin_shot_leg(now);
  if (aimed && take_step(brake_, watch)) {
    ++brake_steps_;
    return tools_.ending->holds(brake_.state(), tools_.goal_depth) ? end_braking() : Outcome::target_not_reached;
  }
  if (braking()) tools_.tree->end_expansion(braking_, 0);
  braking_ = kNone;
  return begin_shot() ? Outcome::target_not_reached : end_step();
}

bool Expander::begin_shot_leg(const Moment& now) {
  Target target;
  const bool aims = last_metres_.aim(now, target);
  if (!aims || shot_legs_ == tools_.spare_expansions) return false;
  MotionTree& tree = *tools_.tree;
  const Index before = braking_;
  braking_ = tree.begin_expansion(before == kNone ? expanded_.last : Branch{before, brake_steps_}, target);
  if (before != kNone) tree.end_expansion(before, brake_steps_);
  ++shot_legs_;
  brake_steps_ = 0;
  brake_.aim(tree.target(braking_));
  return true;
}

Outcome Expander::end_step() {
  recent_.remember(expanded_.last.step, expanded_.region, drive_.state());
  if (!keep_recent(tools_.parameters->tuning.doomed_steps)) return Outcome::tree_full;
  const bool reached = target_distance() <= near_;
  return reached ? Outcome::target_reached : Outcome::target_not_reached;
}

void Expander::begin_braking() {
  Target target = drive_.target();
  target.speed = 0.0F;
  braking_ = tools_.tree->begin_expansion(expanded_.last, target);
  brake_steps_ = 0;
  brake_.begin(drive_.state());
  brake_.aim(tools_.tree->target(braking_));
}

Outcome Expander::take_brake_step(const Watch& watch) {
  const float before = tools_.robot.speed(brake_.state());
  if (take_step(brake_, watch)) {
    ++brake_steps_;
    const float* const state = brake_.state();
    const Ending& ending = *tools_.ending;
    if (ending.holds(state, tools_.goal_depth)) return end_braking();
    const bool slower = tools_.robot.speed(state) < before;
    if (slower && !ending.slow(state) && brake_steps_ < MotionTree::kMostSteps) return Outcome::target_not_reached;
  }
  tools_.tree->end_expansion(braking_, 0);
  braking_ = kNone;
  tools_.check->begin(drive_.state());
  return end_step();
}

Outcome Expander::end_braking() {
  drive_.begin(brake_.state());
  return Outcome::goal_reached;
}

bool Expander::keep_recent(std::uint32_t back) {
  const Branch last = expanded_.last;
  if (last.step <= back) return true;
  const std::uint32_t step = last.step - back;
  return tools_.keeper(recent_.region(step), {last.expansion, step}, recent_.state(step));
}

bool Expander::take_step(Drive& drive, const Watch& watch) {
  if (!ProvenStep(tools_.robot, *tools_.scene, *tools_.parameters, *tools_.check).prove(drive)) return false;
  watch(drive.state(), drive.next());
  drive.go();
  ++tools_.statistics->vertices;
  return true;
}

Index Expander::region_of(Vec2 at, Index last) const {
  const Index triangle = locate(*tools_.scene, at, last);
  return triangle == kNone ? last : tools_.regions->region(triangle);
}

}  // namespace krait::detail
