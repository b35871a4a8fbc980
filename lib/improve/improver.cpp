// SPDX-License-Identifier: Apache-2.0
#include "improve/improver.hpp"

#include <algorithm>

namespace krait::detail {
namespace {

constexpr float kStraightRadius = 20.0F;  // lengths of body 0: a wider turn counts as one of this radius
constexpr float kFarAway = 100.0F;        // lengths of body 0: to a point that the robot does not get near to

// Metres: of one trailer that cuts corners about as much as all of the robot's together.
float trailing_length(const Pose* poses, int bodies) {
  float sum = 0.0F;
  for (int k = 1; k < bodies; ++k) {
    const Vec2 hitch = poses[k].position - poses[k - 1].position;
    sum += dot(hitch, hitch);
  }
  return std::sqrt(sum);
}

// The cosine of the angle between a heading and the way from a to b.
float cosine(SinCos heading, Vec2 a, Vec2 b) {
  const Vec2 way = b - a;
  return (heading.cos * way.x + heading.sin * way.y) / length(way);
}

}  // namespace

Improver::Improver() = default;

void Improver::allocate(Arena& arena, std::uint32_t legs, int state_size) {
  for (Way& way : ways_) way.allocate(arena, legs, state_size);
  best_.allocate(arena, legs, 0);
  const std::uint32_t vias = std::max(legs / 4, kLeastVias);
  for (Route& route : routes_) route.allocate(arena, vias);
  best_route_.allocate(arena, vias);
  line_.allocate(arena, std::max(legs, kLeastPoints));
  drives_.allocate(arena, state_size);
}

void Improver::begin(const WayTools& tools, PlanProof& proof, const Regions& regions, const PlanPath& plan,
                     const EndDepth& depth, const Random& random, bool restarts) {
  tools_ = tools;
  proof_ = &proof;
  regions_ = &regions;
  take_plan(plan);
  depth_ = depth;
  random_ = random;
  robot_length_ = robot_length(tools.robot);
  if (tools.last_metres != nullptr) tools.last_metres->brake(kBraking);
  half_width_ = inner_radius(tools.robot.body(0), middle(tools.robot.body(0)));
  stride_ = 0.0F;
  stopping_ = 0.0F;
  share_ = 0;
  round_ = 0;
  shortest_ = kInfinity;
  best_route_.clear();
  best_kept_ = 0;
  searches_ = 0;
  searched_ = 0;
  const bool may_search = restarts && plan_legs_ <= best_.capacity();
  const bool long_chain = tools.robot.body_count() >= kLongChain;
  searches_in_vain_ = may_search && !long_chain;
  if (may_search && long_chain) searches_ = kSearches;
  if (may_search) take_found(plan);
  stage_ = Stage::turning;
}

bool Improver::iterate() {
  switch (stage_) {
    case Stage::searching:
      break;
    case Stage::turning:
      measure_turn();
      break;
    case Stage::keeping:
      keep();
      break;
    case Stage::tracing:
      trace();
      break;
    case Stage::pulling:
      pull();
      break;
    case Stage::driving:
      drive();
      break;
    case Stage::proving:
      return prove();
  }
  return false;
}

void Improver::take_plan(const PlanPath& plan) {
  plan_ = plan;
  const Size size = this->size(plan);
  plan_legs_ = size.legs;
  plan_steps_ = size.steps;
  for (Index leg = plan.first(); leg != kNone; leg = plan.next(leg)) {
    const float speed = plan.target(leg).speed;
    if (speed != 0.0F) ends_ahead_ = speed > 0.0F;  // the last leg may be a brake
  }
}

Improver::Size Improver::size(const PlanPath& plan) {
  Size size{};
  for (Index leg = plan.first(); leg != kNone; leg = plan.next(leg)) {
    ++size.legs;
    size.steps += plan.steps(leg);
  }
  return size;
}

bool Improver::is_better(const PlanPath& found) const {
  const Size size = this->size(found);
  return size.steps < plan_steps_ && size.legs <= best_.capacity();
}

void Improver::take_found(const PlanPath& found) {
  best_.clear();
  for (Index leg = found.first(); leg != kNone; leg = found.next(leg)) best_.add(found.packed(leg), found.steps(leg));
  take_plan(PlanPath(best_, tools_.grid));
  best_route_.clear();
  best_kept_ = 0;
}

void Improver::measure_turn() {
  tools_.drive->begin(tools_.start);
  Pose pose[kMaxBodies];
  tools_.robot.place(tools_.start, pose);
  float path = 0.0F;
  float turned = 0.0F;
  for (std::uint32_t step = 0; step < kRunUp + kTurning; ++step) {
    if (step % kHold == 0) aim_aside(pose[0], step >= kRunUp);
    const Pose before = pose[0];
    tools_.drive->step();
    tools_.robot.place(tools_.drive->state(), pose);
    const float made = length(pose[0].position - before.position);
    if (made > stride_) stride_ = made;
    stopping_ = std::max(stopping_, math::absolute(tools_.robot.stopping_way(tools_.drive->state())));
    if (step < kRunUp + kTurning - kMeasured) continue;
    path += made;
    turned += length(Vec2{pose[0].heading.cos - before.heading.cos, pose[0].heading.sin - before.heading.sin});
  }
  const float most = kStraightRadius * robot_length_;
  turns_.radius[share_] = path < most * turned ? path / turned : most;
  if (share_ == 0) sharpest_ = turned / static_cast<float>(kMeasured);
  if (++share_ < Turns::kShares) return;
  turns_.unit = 0.5F * robot_length_ + 2.0F * stride_;
  if (chooses_shots() && sharpest_ > 0.0F) tools_.last_metres->count_turns(stride_ / sharpest_);
  tools_.robot.place(tools_.start, pose);
  trailing_ = trailing_length(pose, tools_.robot.body_count());
  turns_.trail = straightens() ? trailing_ : 0.0F;
  begin_round();
}

void Improver::aim_aside(const Pose& pose, bool to_the_left) {
  const Vec2 ahead{pose.heading.cos, pose.heading.sin};
  const Vec2 aside{-ahead.y, ahead.x};
  Target target;
  target.point = pose.position + kFarAway * robot_length_ * (to_the_left ? aside : ahead);
  target.turn = Turns::kShare[share_];
  tools_.drive->aim(target);
}

void Improver::begin_round() {
  if (searches_in_vain_) searches_ = round_ > 0 && in_vain() ? 1 : 0;
  if (searches_next()) {
    if (tools_.last_metres != nullptr) tools_.last_metres->draw_with({});
    ++searched_;
    stage_ = Stage::searching;
  } else {
    searched_ = 0;
    begin_line();
  }
}

void Improver::begin_line() {
  if (takes_shortcut()) {
    round_ += round_ % 2;  // so that this round's line is that of the regions
  } else if (best_route_.count() > 0 && random_.unit() < kAgain) {
    route().copy(best_route_);
    return begin_keeping(best_kept_);
  }
  ++round_;
  line_.clear(kSpacing * turns_.unit);
  route().clear();
  begin_keeping(legs_to_keep());
}

bool Improver::in_vain() const { return best_route_.count() == 0 || best_kept_ > 0 || best_route_.gear() < 0.0F; }

std::uint32_t Improver::legs_to_keep() {
  const std::uint32_t legs = std::min(plan_legs_, current().capacity());
  if (round_ <= kFromStart || !in_vain() || legs < 3 || random_.unit() >= kKeep) return 0;
  const float share = random_.unit();
  return 1 + static_cast<std::uint32_t>(share * share * static_cast<float>(legs - 2));
}

void Improver::begin_keeping(std::uint32_t legs) {
  kept_ = legs;
  current().clear();
  tools_.drive->begin(tools_.start);
  leg_ = plan_.first();
  step_ = 0;
  stage_ = Stage::keeping;
  if (legs == 0) end_keeping();
}

void Improver::keep() {
  for (std::uint32_t remaining = tools_.parameters->tuning.max_steps; remaining > 0; --remaining) {
    if (step_ == 0) current().add(plan_.packed(leg_), Leg::kOffRoute, tools_.drive->state());
    current().step();
    if (follow_plan() && current().count() == kept_) return end_keeping();
  }
}

bool Improver::follow_plan() {
  if (step_ == 0) tools_.drive->aim(plan_.target(leg_));
  tools_.drive->step();
  if (++step_ < plan_.steps(leg_)) return false;
  step_ = 0;
  leg_ = plan_.next(leg_);
  return true;
}

void Improver::end_keeping() {
  if (route().count() > 0) return begin_search();
  const Vec2 from{tools_.drive->state()[0], tools_.drive->state()[1]};
  const bool backs = kept_ > 0 && plan_.target(leg_).speed < 0.0F;
  gear_ = backs && random_.unit() < kBackwards ? -1.0F : 1.0F;
  if (round_ % 2 == 1 && trace_regions(from)) return begin_pull();
  stage_ = Stage::tracing;
  line_.add(from);
}

bool Improver::straightens() const {
  const LastMetres* const last_metres = tools_.last_metres;
  return last_metres != nullptr && last_metres->asks_for_straight() && tools_.robot.body_count() > 1 && ends_ahead_;
}

bool Improver::takes_shortcut() {
  const float plan = stride_ * static_cast<float>(plan_steps_);
  return straightens() && shortest_ < kShortcut * plan && random_.unit() < kTakeShortcut;
}

bool Improver::trace_regions(Vec2 from) {
  const Scene& scene = *tools_.scene;
  Index triangle = locate(scene, from);
  if (triangle == kNone || regions_->cost(regions_->region(triangle)) == kInfinity) return false;
  line_.add(from);
  while (!regions_->is_goal(regions_->region(triangle))) {
    const Index next = regions_->next(triangle);
    for (int edge = 0; edge < 3; ++edge) {
      const Index neighbor = scene.neighbor(triangle, edge);
      if (neighbor == kNone || regions_->region(neighbor) != next) continue;
      line_.add(0.5F * (scene.corner(triangle, edge) + scene.corner(triangle, (edge + 1) % 3)));
      triangle = neighbor;
      break;
    }
  }
  const Goal& goal = regions_->goal();
  line_.end(goal.is_disc() ? goal.center() : scene.centroid(triangle));
  return true;
}

void Improver::trace() {
  for (std::uint32_t remaining = tools_.parameters->tuning.max_steps; remaining > 0; --remaining) {
    follow_plan();
    const Vec2 at{tools_.drive->state()[0], tools_.drive->state()[1]};
    if (leg_ == kNone) {
      line_.end(at);
      return begin_pull();
    }
    line_.add(at);
  }
}

void Improver::begin_pull() {
  const float least = kLeastDisc * half_width_;
  const float widest = least + kMoreDisc * half_width_ * random_.unit();
  line_.pull(Sight::in(*tools_.scene, widest, kPullStep * half_width_), least);
  stage_ = Stage::pulling;
}

void Improver::pull() {
  if (line_.step()) return;
  if (line_.count() < 2 || line_.count() > route().capacity()) return begin_round();
  make_route();
  begin_search();
}

void Improver::make_route() {
  Via via{};
  vary(via, turns_, random_);
  route().clear();
  for (std::uint32_t i = 0; i < line_.count(); ++i) {
    via.at = line_[i];
    route().add(via);
  }
  if (random_.unit() < kRounded) {
    for (std::uint32_t i = 1; i + 1 < line_.count(); ++i) {
      round_corner(line_[i - 1], route()[i], line_[i + 1], turns_, random_);
    }
  }
  route().measure();
  divide_stretches();
  if (kept_ > 0) {
    route().drive_in(gear_);
  } else {
    if (round_ % 2 == 1) shortest_ = route().length();
    if (saves_turns_backwards() && random_.unit() < kBackwards) route().drive_in(-1.0F);
  }
  if (chooses_shots()) change_shots(route());
}

bool Improver::divide_before(Route& route, std::uint32_t i) const {
  const float near = kSpread * turns_.unit;
  const float arc = route[i].arc;
  if (!(arc - route[i - 1].arc > kFar * near) || route.full()) return false;
  route.divide(arc - near);
  return true;
}

void Improver::divide_stretches() {
  for (std::uint32_t i = route().count() - 2; i > 0; --i) (void)divide_before(route(), i);
  const float near = kSpread * turns_.unit;
  if (route()[1].arc > kFar * near && !route().full()) route().divide(near);
}

bool Improver::chooses_shots() const {
  return tools_.last_metres != nullptr && tools_.robot.turning_radius(robot_length_) == 0.0F;
}

void Improver::vary_shots() {
  if (tools_.last_metres == nullptr) return;
  LastMetres::Lines lines;
  if (straightens() && random_.unit() < kOtherShots) {
    lines.radii = kLeastArcs + kMoreArcs * random_.unit();
    lines.leads = kLeastLeads + kMoreLeads * random_.unit();
    lines.detours = false;
  }
  tools_.last_metres->draw_with(lines);
}

float Improver::change_shots(Route& route) {
  const float before = route.shots();
  const float share = random_.unit() * (1.0F + kNoShots) - kNoShots;
  route.shoot_within(share > 0.0F ? share * tools_.last_metres->capture() : 0.0F);
  return route.length() - std::max(before, route.shots());
}

bool Improver::saves_turns_backwards() const {
  if (!tools_.robot.reversible() || tools_.robot.body_count() > 1) return false;
  Pose pose;
  tools_.robot.place(tools_.start, &pose);
  const std::uint32_t last = line_.count() - 1;
  const Goal& goal = regions_->goal();
  float ahead = cosine(pose.heading, line_[0], line_[1]);
  if (goal.is_pose() && !goal.facing().either_way) {
    ahead += cosine(math::sin_cos(goal.facing().heading), line_[last - 1], line_[last]);
  }
  return ahead < -kWorthBackwards;
}

void Improver::begin_search() {
  vary_shots();
  const std::uint32_t room = current().capacity() / (tools_.last_metres == nullptr ? 1 : 2);
  const std::uint32_t hold = std::max(plan_steps_ / room + 1, kHold);
  const float near = 0.5F * regions_->goal().size(*tools_.scene);
  drives_.assign(tools_, {hold, stride_, kSearchAhead * turns_.unit, near});
  const Parameters& parameters = *tools_.parameters;
  tools_.check->keep(parameters.clearance + kTreeSlack * robot_length_, longest_tree_step(tools_.robot, parameters.dt));
  stage_ = Stage::driving;
  repairing_ = false;
  corner_ = 0;
  returns_ = kReturns;
  next_corner();
}

void Improver::begin_drive(std::uint32_t leg, float until) {
  drives_.begin(trial(), current(), leg, changed(), plan_steps_, until);
}

void Improver::drive() {
  const Outcome outcome = drives_.advance(tools_.parameters->tuning.max_steps);
  if (outcome == Outcome::drives) return;
  if (outcome == Outcome::reached) {
    accept();
    return begin_proof();
  }
  if (!repairing_) return learn_corner(outcome);
  ++vain_;
  if (outcome == Outcome::blocked) learn_blocked();
  repair();
}

void Improver::begin_corner(std::uint32_t corner, std::uint32_t tries) {
  corner_ = corner;
  tries_ = tries;
  least_steps_ = kInfinity;
  from_leg_ = leg_at_end_of_corner(corner - 1);
}

void Improver::next_corner() {
  begin_corner(corner_ + 1, 0);
  changed().copy(route());
  drive_corner();
}

bool Improver::turns() {
  if (corner_ == 1 || corner_ + 1 == route().count()) return true;
  const Vec2 in = route()[corner_].at - route()[corner_ - 1].at;
  const Vec2 out = route()[corner_ + 1].at - route()[corner_].at;
  return !(dot(in, out) > kStraightOn * (length(in) * length(out)));
}

float Improver::end_of_corner(const Route& route, std::uint32_t corner) const {
  if (corner == 0) return 0.0F;
  const float at = route[corner].arc;
  return at + std::min(kPast * turns_.unit + trailing_, 0.5F * (route[corner + 1].arc - at));
}

std::uint32_t Improver::leg_at_end_of_corner(std::uint32_t corner) {
  const float end = end_of_corner(route(), corner);
  std::uint32_t leg = kept_;
  while (leg + 1 < current().count() && current()[leg + 1].arc < end) ++leg;
  return leg;
}

void Improver::drive_corner() {
  const bool last = corner_ + 1 == changed().count();
  begin_drive(from_leg_, last ? kInfinity : end_of_corner(changed(), corner_) + stopping_);
}

void Improver::learn_corner(Outcome outcome) {
  ++tries_;
  if (outcome == Outcome::passed) learn_passed();
  const bool passed = least_steps_ < kInfinity;
  const std::uint32_t enough = best_route_.count() > 0 && turns() ? kTries : 1;
  if (tries_ < (passed ? enough : kMostTries)) return try_corner();
  if (passed) return next_corner();
  if (outcome != Outcome::blocked) return begin_round();
  if (corner_ > 1 && returns_ > 0) return return_to_corner_before();
  begin_repair();
}

void Improver::return_to_corner_before() {
  --returns_;
  begin_corner(corner_ - 1, kTries - 1);
  try_corner();
}

void Improver::begin_repair() {
  repairing_ = true;
  vain_ = 0;
  remaining_ = kInfinity;
  learn_blocked();
  repair();
}

void Improver::learn_passed() {
  const float least = this->least_steps();
  if (!(least < least_steps_)) return;
  least_steps_ = least;
  accept();
}

float Improver::least_steps() {
  const float ahead = kAhead * turns_.unit;
  const Pose& pose = tools_.check->poses()[0];
  const Vec2 next = changed().point(drives_.arc() + ahead);
  const float way = length(next - pose.position);
  const float aside = way > 0.0F ? 1.0F - changed().gear() * cosine(pose.heading, pose.position, next) : 0.0F;
  const float rest = std::max(changed().length() - drives_.arc() - ahead, 0.0F);
  return static_cast<float>(trial().steps()) + (way + rest + kAskew * turns_.unit * aside) / stride_;
}

void Improver::try_corner() {
  changed().copy(route());
  change_via(changed(), corner_, turns_, random_);
  keep_end();
  if (chooses_shots() && corner_ + 1 == changed().count()) change_shots(changed());
  drive_corner();
}

void Improver::learn_blocked() {
  const float remaining = changed().length() - drives_.arc();
  if (remaining < remaining_ - kNearer * turns_.unit) {
    vain_ = 0;
  } else if (!(remaining <= remaining_ + kAsNear * turns_.unit && random_.unit() < kTakenAsNear)) {
    return;
  }
  remaining_ = remaining;
  failed_ = drives_.arc();
  accept();
}

void Improver::accept() {
  here_ = 1 - here_;
  here_of_routes_ = 1 - here_of_routes_;
}

void Improver::repair() {
  if (vain_ >= kPatience) return begin_round();
  changed().copy(route());
  const std::uint32_t i = spread_around(via_near_failure());
  float from = changed()[i - 1].arc;
  if (chooses_shots() && (i + 1 == changed().count() || random_.unit() < kVaryShots)) {
    from = std::min(from, change_shots(changed()));
  }
  const std::uint32_t leg = first_that_sees(from);
  change(changed(), i, turns_, random_);
  keep_end();
  begin_drive(leg, kInfinity);
}

void Improver::keep_end() {
  const bool ends_in_goal = regions_->goal().contains(*tools_.scene, changed().last().at, 0.0F);
  if (!ends_in_goal) changed()[changed().count() - 1].at = route().last().at;
  changed().measure();
}

std::uint32_t Improver::via_near_failure() {
  const float at =
      math::clamp(failed_ + (kAroundFailure * random_.unit() - kBeforeFailure) * turns_.unit, 0.0F, route().length());
  const std::uint32_t next = changed().stretch(at);
  const float before = at - changed()[next - 1].arc;
  const float after = changed()[next].arc - at;
  const float near = kNearFailure * turns_.unit;
  if (before > near && after > near && !changed().full()) return changed().divide(at);
  return before < after && next > 1 ? next - 1 : next;
}

std::uint32_t Improver::spread_around(std::uint32_t i) {
  const float arc = changed()[i].arc;
  const float near = kSpread * turns_.unit;
  if (divide_before(changed(), i)) ++i;
  const bool far = i + 1 < changed().count() && changed()[i + 1].arc - arc > kFar * near;
  if (far && !changed().full()) changed().divide(arc + near);
  return i;
}

std::uint32_t Improver::first_that_sees(float from) {
  const std::uint32_t count = current().count();
  const float reach = kSearchAhead * turns_.unit;
  for (std::uint32_t leg = 0; leg < count; ++leg) {
    const float arc = current()[leg].arc;
    const float look = route()[route().stretch(arc)].look;
    if (!(arc + (look > reach ? look : reach) < from)) return leg;
  }
  std::uint32_t last = count > kept_ ? count - 1 : kept_;
  while (last > kept_ && current()[last].arc == Leg::kOffRoute) --last;
  return last;
}

void Improver::begin_proof() {
  stage_ = Stage::proving;
  leg_ = 0;
  step_ = 0;
  proof_->begin(tools_.robot, *tools_.scene, *tools_.parameters, *tools_.check, tools_.start);
  proof_->place();
}

bool Improver::prove() {
  for (std::uint32_t remaining = tools_.parameters->tuning.max_steps; remaining > 0; --remaining) {
    if (leg_ == current().count()) return finish_proof();
    const Leg& leg = current()[leg_];
    if (step_ == 0) proof_->aim(tools_.grid.unpack(leg.target));
    if (!proof_->step()) {
      begin_round();
      return false;
    }
    if (++step_ < leg.steps) continue;
    step_ = 0;
    ++leg_;
  }
  proof_->keep();
  return false;
}

bool Improver::finish_proof() {
  const bool holds = tools_.ending->holds(proof_->state(), proof_->end_depth(depth_));
  if (holds) {
    measures_ = proof_->measures();
    best_.copy(current(), current().count());
    take_plan(PlanPath(best_, tools_.grid));
    best_route_.copy(route());
    best_kept_ = kept_;
  }
  begin_round();
  return holds;
}

}  // namespace krait::detail
