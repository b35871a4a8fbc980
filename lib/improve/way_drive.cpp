// SPDX-License-Identifier: Apache-2.0
#include "improve/way_drive.hpp"

#include <algorithm>

namespace krait::detail {

void WayDrive::allocate(Arena& arena, int state_size) {
  resumed_from_ = arena.allocate<float>(Pool::improvement, static_cast<std::uint32_t>(state_size));
}

void WayDrive::assign(const WayTools& tools, const Manner& manner) {
  tools_ = &tools;
  manner_ = manner;
  step_ = ProvenStep(tools.robot, *tools.scene, *tools.parameters, *tools.check);
  resumed_after_ = kNone;
}

void WayDrive::begin(Way& way, const Way& from, std::uint32_t legs, const Route& route, std::uint32_t bound,
                     float until) {
  way_ = &way;
  route_ = &route;
  bound_ = bound;
  until_ = until;
  if (legs == resumed_after_) {
    tools_->drive->begin(resumed_from_);
  } else {
    drive_again(from, legs);
    std::copy_n(tools_->drive->state(), tools_->robot.state_size(), resumed_from_);
    resumed_after_ = legs;
  }
  way.copy(from, legs);
  tools_->check->begin(tools_->drive->state());
  arc_ = legs < from.count() ? from[legs].arc : 0.0F;
  furthest_ = arc_;
  stuck_ = 0;
  remaining_ = 0;
  braking_ = false;
  shooting_ = false;
  next_shots_ = route.shots();
}

WayDrive::Outcome WayDrive::advance(std::uint32_t steps) {
  for (; steps > 0; --steps) {
    if (shooting_) {
      if (shoot()) return Outcome::reached;
      continue;
    }
    if (remaining_ == 0 && !braking_) {
      const Outcome outcome = begin_leg();
      if (outcome != Outcome::drives) return outcome;
    }
    if (braking_) {
      if (brake()) return Outcome::reached;
      continue;
    }
    if (!take_step(*tools_->drive)) return Outcome::blocked;
    --remaining_;
    const float* const state = tools_->drive->state();
    if (tools_->ending->holds(state, tools_->depth)) return Outcome::reached;
    if (way_->steps() + 1 >= bound_) return Outcome::too_long;
    if (!way_->full() && tools_->ending->stops_inside(state, tools_->check->poses()[0])) begin_braking();
    if (remaining_ == 0 && !braking_) begin_shots();
  }
  return Outcome::drives;
}

void WayDrive::drive_again(const Way& way, std::uint32_t legs) {
  Drive& drive = *tools_->drive;
  const std::uint32_t last = std::min(legs, way.count() > 0 ? way.count() - 1 : 0);
  const std::uint32_t first = last - last % Way::kLegsAState;
  drive.begin(way.count() > 0 ? way.state(first) : tools_->start);
  for (std::uint32_t i = first; i < legs; ++i) {
    drive.aim(tools_->grid.unpack(way[i].target));
    for (std::uint32_t step = 0; step < way[i].steps; ++step) drive.step();
  }
}

bool WayDrive::take_step(Drive& drive) {
  if (!step_.prove(drive)) return false;
  way_->step();
  drive.go();
  return true;
}

void WayDrive::begin_braking() {
  const float* const state = tools_->drive->state();
  Target target = tools_->drive->target();
  target.speed = 0.0F;
  const PackedTarget packed = tools_->grid.pack(target);
  way_->add(packed, route_->project({state[0], state[1]}, arc_, manner_.reach), state);
  tools_->brake->begin(state);
  tools_->brake->aim(tools_->grid.unpack(packed));
  braking_ = true;
}

bool WayDrive::brake() {
  Drive& drive = *tools_->brake;
  const float before = tools_->robot.speed(drive.state());
  if (take_step(drive)) {
    if (tools_->ending->holds(drive.state(), tools_->depth)) return true;
    const float after = tools_->robot.speed(drive.state());
    if (after < before && !tools_->ending->slow(drive.state()) && way_->steps() + 1 < bound_) return false;
  }
  way_->remove_last();
  tools_->check->begin(tools_->drive->state());
  braking_ = false;
  return false;
}

void WayDrive::begin_shots() {
  LastMetres* const last_metres = tools_->last_metres;
  const float* const state = tools_->drive->state();
  const float remaining = route_->length() - arc_;
  if (last_metres == nullptr || remaining > next_shots_) return;
  if (!last_metres->near({state[0], state[1]})) return;
  next_shots_ = kNextShots * remaining;
  last_metres->choose(tools_->check->poses());
  shot_ = way_->count();
  shooting_ = begin_shot();
}

bool WayDrive::begin_shot() {
  const float* const state = tools_->drive->state();
  tools_->check->begin(state);
  tools_->brake->begin(state);
  leg_steps_ = LastMetres::kLongest;
  return tools_->last_metres->next(tools_->check->poses());
}

bool WayDrive::shoot() {
  Drive& drive = *tools_->brake;
  const Moment now{tools_->robot, drive.state(), tools_->check->poses()};
  const bool aimed = !tools_->last_metres->leg_over(leg_steps_, now) || begin_shot_leg(now);
  if (aimed && take_step(drive)) {
    ++leg_steps_;
    if (tools_->ending->holds(drive.state(), tools_->depth)) return true;
    if (way_->steps() + 1 < bound_) return false;
  }
  while (way_->count() > shot_) way_->remove_last();
  shooting_ = begin_shot();
  return false;
}

bool WayDrive::begin_shot_leg(const Moment& now) {
  Target target;
  if (way_->full() || !tools_->last_metres->aim(now, target)) return false;
  if (too_long(tools_->last_metres->least_remaining(now))) return false;
  const PackedTarget packed = tools_->grid.pack(target);
  way_->add(packed, way_->count() == shot_ ? arc_ : Leg::kOffRoute, now.state);
  tools_->brake->aim(tools_->grid.unpack(packed));
  leg_steps_ = 0;
  return true;
}

float WayDrive::slow_share(const float* state) const {
  if (!tools_->ending->limits_speed()) return 1.0F;
  const float way = math::absolute(tools_->robot.stopping_way(state));
  const float distance = length(route_->last().at - Vec2{state[0], state[1]});
  return distance < way ? std::sqrt(distance / way) : 1.0F;
}

WayDrive::Outcome WayDrive::begin_leg() {
  if (way_->full()) return Outcome::full;
  const float* const state = tools_->drive->state();
  arc_ = route_->project({state[0], state[1]}, arc_, manner_.reach);
  if (arc_ >= until_) return Outcome::passed;
  if (arc_ > furthest_ + kFurther * manner_.reach) {
    furthest_ = arc_;
    stuck_ = 0;
  } else if (++stuck_ > kMostStuck) {
    return Outcome::blocked;
  }
  if (too_long(route_->length() - arc_)) return Outcome::too_long;
  const Via& via = (*route_)[route_->stretch(arc_)];
  Target target;
  target.point = route_->point(arc_ + via.look);
  target.turn = via.turn;
  target.speed = route_->gear() * slow_share(state);
  const PackedTarget packed = tools_->grid.pack(target);
  way_->add(packed, arc_, state);
  tools_->drive->aim(tools_->grid.unpack(packed));
  remaining_ = manner_.hold;
  return Outcome::drives;
}

bool WayDrive::too_long(float remaining) const {
  const float rest = kLeastShare * (remaining - manner_.near) / manner_.stride;
  return static_cast<float>(way_->steps()) + (rest > 1.0F ? rest : 1.0F) >= static_cast<float>(bound_);
}

}  // namespace krait::detail
