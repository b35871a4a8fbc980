// SPDX-License-Identifier: Apache-2.0
// Drives a robot along a route, leg by leg: a leg is some steps at full speed toward the place ahead on the route that
// its stretch says, and every step is proven as the tree's are.
#pragma once

#include "krait/improve/route.hpp"
#include "krait/plan/ending.hpp"
#include "krait/plan/proven_step.hpp"
#include "krait/plan/way.hpp"

namespace krait {

// What a way is driven by; all of it must stay.
template <Robot R>
struct WayTools {
  const R* robot = nullptr;
  const Scene* scene = nullptr;
  const Parameters* parameters = nullptr;
  MotionCheck<R>* check = nullptr;
  Drive<R>* drive = nullptr;
  Drive<R>* brake = nullptr;
  TargetGrid grid;
  const Ending<R>* ending = nullptr;
  float depth = 0.0F;            // metres: how deep inside the goal a way ends
  const float* start = nullptr;  // state_size() floats
};

template <Robot R>
class WayDrive {
 public:
  enum class Outcome {
    drives,    // has not ended
    reached,   // the way ends the plan
    blocked,   // a step is not free, or the robot gets no further
    too_long,  // it would not have fewer steps than asked for
    full       // the way has no room for more legs
  };

  // The tools must outlive this. What is the same for all ways: legs of `hold` steps, `stride` metres the longest step
  // that the robot has made, `reach` metres how far on along the route its place is looked for, `near` metres how far
  // from the route's end a way may end.
  struct Manner {
    std::uint32_t hold;
    float stride;
    float reach;
    float near;
  };

  void assign(const WayTools<R>& tools, const Manner& manner) {
    tools_ = &tools;
    manner_ = manner;
    step_ = ProvenStep<R>(*tools.robot, *tools.scene, *tools.parameters, *tools.check);
  }

  // Makes `way` the first `legs` legs of `from`, or of none, and drives on from there along the measured route, while
  // it may have fewer than `bound` steps. Drives at most Way::kLegsAState of the legs again.
  void begin(Way& way, const Way& from, std::uint32_t legs, const Route& route, std::uint32_t bound) {
    way_ = &way;
    route_ = &route;
    bound_ = bound;
    const std::uint32_t first = legs - legs % Way::kLegsAState;
    const bool known = first < from.count();
    tools_->drive->begin(known ? from.state(first) : tools_->start);
    for (std::uint32_t i = first; i < legs; ++i) drive_again(from[i]);
    way.copy(from, legs);
    tools_->check->begin(tools_->drive->state());
    arc_ = legs < from.count() ? from[legs].arc : 0.0F;
    furthest_ = arc_;
    stuck_ = 0;
    left_ = 0;
    braking_ = false;
    rival_ = nullptr;
  }

  // From `from` metres along the route on the way ends as too long where it is later than a rival, a way that reached
  // the end of a route of `length` metres which goes on as this one does from there.
  void race(const Way& rival, float length, float from) {
    rival_ = &rival;
    rival_length_ = length;
    rival_leg_ = 0;
    rival_steps_ = 0;
    from_ = from;
  }

  // At most so many steps more.
  Outcome advance(std::uint32_t steps) {
    for (; steps > 0; --steps) {
      if (left_ == 0 && !braking_) {
        const Outcome outcome = begin_leg();
        if (outcome != Outcome::drives) return outcome;
      }
      if (braking_) {
        if (brake()) return Outcome::reached;
        continue;
      }
      if (!take_step(*tools_->drive)) return Outcome::blocked;
      --left_;
      const float* const state = tools_->drive->state();
      if (tools_->ending->holds(state, tools_->depth)) return Outcome::reached;
      if (way_->steps() + 1 >= bound_) return Outcome::too_long;
      if (!way_->full() && tools_->ending->stops_inside(state, tools_->check->poses()[0])) begin_braking();
    }
    return Outcome::drives;
  }

  // Metres along the route that the last leg begins at.
  float arc() const { return arc_; }

 private:
  static constexpr std::uint32_t kMostStuck = 12;  // legs that get no further along the route
  static constexpr float kFurther = 0.025F;        // of `reach`: what counts as further
  static constexpr float kLater = 0.5F;            // steps
  static constexpr float kLeastShare = 0.97F;      // of the route that is left, below which no way on is

  // The same bits as when the leg was driven first.
  void drive_again(const Leg& leg) {
    Drive<R>& drive = *tools_->drive;
    Pose poses[R::kMaxBodies];
    drive.aim(tools_->grid.unpack(leg.target));
    for (std::uint32_t step = 0; step < leg.steps; ++step) {
      tools_->robot->place(StateView(drive.state(), tools_->robot->state_size()), poses);
      drive.lead(poses);
      drive.follow(poses);
      drive.go();
    }
  }

  // False when the step is not free.
  bool take_step(Drive<R>& drive) {
    if (!step_.take(drive)) return false;
    const float* const from = drive.state();
    const float* const to = drive.next();
    way_->step(length(Vec2{to[0] - from[0], to[1] - from[1]}));
    drive.go();
    return true;
  }

  // The brake is a leg of its own, toward the same target.
  void begin_braking() {
    const float* const state = tools_->drive->state();
    Target target = tools_->drive->target();
    target.speed = 0.0F;
    const PackedTarget packed = tools_->grid.pack(target);
    way_->add(packed, route_->project({state[0], state[1]}, arc_, manner_.reach), state);
    tools_->brake->begin(state);
    tools_->brake->aim(tools_->grid.unpack(packed));
    braking_ = true;
  }

  // One step of the brake; whether it ends the plan. Where it cannot, the way goes on from where the brake began.
  bool brake() {
    Drive<R>& drive = *tools_->brake;
    const float before = speed_of(*tools_->robot, StateView(drive.state(), tools_->robot->state_size()));
    if (take_step(drive)) {
      if (tools_->ending->holds(drive.state(), tools_->depth)) return true;
      const float after = speed_of(*tools_->robot, StateView(drive.state(), tools_->robot->state_size()));
      if (after < before && !tools_->ending->slow(drive.state()) && way_->steps() + 1 < bound_) return false;
    }
    way_->remove_last();
    tools_->check->begin(tools_->drive->state());
    braking_ = false;
    return false;
  }

  // So slow that the robot can stop where the route ends.
  float slow_share(const float* state) const {
    if (!tools_->ending->limits_speed()) return 1.0F;
    const float way = absolute(stopping_way(*tools_->robot, StateView(state, tools_->robot->state_size())));
    const float distance = length(route_->last().at - Vec2{state[0], state[1]});
    return distance < way ? std::sqrt(distance / way) : 1.0F;
  }

  Outcome begin_leg() {
    if (way_->full()) return Outcome::full;
    const float* const state = tools_->drive->state();
    arc_ = route_->project({state[0], state[1]}, arc_, manner_.reach);
    if (arc_ > furthest_ + kFurther * manner_.reach) {
      furthest_ = arc_;
      stuck_ = 0;
    } else if (++stuck_ > kMostStuck) {
      return Outcome::blocked;
    }
    const float rest = kLeastShare * (route_->length() - arc_ - manner_.near) / manner_.stride;
    if (static_cast<float>(way_->steps()) + rest >= static_cast<float>(bound_)) return Outcome::too_long;
    if (rival_ != nullptr && arc_ > from_ && later()) return Outcome::too_long;
    const Via& via = (*route_)[route_->stretch(arc_)];
    Target target;
    target.point = route_->point(arc_ + via.look);
    target.turn = via.turn;
    target.speed = slow_share(state);
    const PackedTarget packed = tools_->grid.pack(target);
    way_->add(packed, arc_, state);
    tools_->drive->aim(tools_->grid.unpack(packed));
    left_ = manner_.hold;
    return Outcome::drives;
  }

  // Whether the rival came to where as much of its route is left in fewer steps.
  bool later() {
    const float arc = rival_length_ - (route_->length() - arc_);
    const Way& rival = *rival_;
    while (rival_leg_ + 1 < rival.count() && rival[rival_leg_ + 1].arc <= arc)
      rival_steps_ += rival[rival_leg_++].steps;
    const Leg& leg = rival[rival_leg_];
    if (rival_leg_ + 1 == rival.count()) return false;
    const float whole = rival[rival_leg_ + 1].arc - leg.arc;
    const float share = whole > 0.0F ? (arc - leg.arc) / whole : 0.0F;
    const float steps = static_cast<float>(rival_steps_) + share * static_cast<float>(leg.steps);
    return static_cast<float>(way_->steps()) > steps + kLater;
  }

  const WayTools<R>* tools_ = nullptr;
  Manner manner_{};
  ProvenStep<R> step_;
  Way* way_ = nullptr;
  const Route* route_ = nullptr;
  std::uint32_t bound_ = 0;
  float arc_ = 0.0F;
  float furthest_ = 0.0F;  // of arc_, from where on it counted as further
  std::uint32_t stuck_ = 0;
  std::uint32_t left_ = 0;  // steps of the leg
  bool braking_ = false;    // whether the last leg is a brake
  const Way* rival_ = nullptr;
  float rival_length_ = 0.0F;
  float from_ = 0.0F;
  std::uint32_t rival_leg_ = 0;    // that the rival was in where as much of its route was left, and
  std::uint32_t rival_steps_ = 0;  // its steps before that
};

}  // namespace krait
