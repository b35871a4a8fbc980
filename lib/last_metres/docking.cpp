// SPDX-License-Identifier: Apache-2.0
#include "last_metres/docking.hpp"

#include <algorithm>

#include "krait/robots/detail/functions.hpp"
#include "last_metres/arc.hpp"
#include "last_metres/last_metres.hpp"

namespace krait::detail {
namespace {

// Measured: bench/ABLATIONS.md, "Trucks dock".
constexpr float kHoldWay = 0.6F;     // lengths of body 0 that a leg goes at the top speed, at least
constexpr float kPushLook = 1.125F;  // distances from body 0 to the last trailer: how far ahead of that it steers
// Mean hitch lengths that trailers are pushed, at most: after them what rounding has put three trailers off by is as
// much as a plan's proof allows.
constexpr float kMostPush = 6.5F;
constexpr float kStages[] = {0.5F, 0.8F, 0.9F, 1.0F};  // shares of the longest push: where trailers are pulled straight
constexpr float kSwingRadius = 0.55F;                  // mean hitch lengths: radius of a swing's arcs
constexpr float kSwings[] = {0.4F, 0.5F};              // radians that a swing turns too far, and back
constexpr float kSwingAim = 0.45F;  // radii of the goal: how far ahead of its centre, and aside of it, a swing ends
constexpr float kSwingTilt = 0.8F;  // tolerances of the heading: how far short of the heading a swing ends
constexpr float kDrawStep = 0.15F;  // mean hitch lengths: the longest step in which trailers are drawn along a line,
                                    // unless that needs more than kMostSteps
constexpr int kMostSteps = 128;     // steps in which trailers are drawn, at most
constexpr float kFold = 0.62F;      // the least cosine of a hitch angle while trailers are drawn
constexpr float kStraightEnough = 0.9F;  // tolerances of the hitches: the most sine of a hitch angle in the end

void measure(LastMetres& last_metres, const Pose* poses) { last_metres.measure_push(poses); }
void choose(LastMetres& last_metres, const Pose* poses) {
  if (last_metres.choose_swings(poses)) return;
  last_metres.measure_push(poses);
  last_metres.choose_stages(poses);
}

bool allows(const LastMetres& last_metres, const Pose* poses, const Shot& shot, const CurvedLine& line) {
  return last_metres.allows(poses, shot, line);
}

void turn_back(LastMetres& last_metres) { last_metres.turn_back(); }

}  // namespace

const Docking kDocking = {measure, choose, allows, turn_back};

void LastMetres::measure_push(const Pose* poses) {
  swung_ = false;
  look_ = kLook * robot_.length;
  const int last = robot_.backing_body;
  reach_back_ = 0.0F;
  for (int k = 0; k < last; ++k) reach_back_ = reach_back_ + length(poses[k + 1].position - poses[k].position);
  most_push_ = kMostPush * reach_back_ / static_cast<float>(last);
  push_look_ = kPushLook * reach_back_;
  const float steps = kHoldWay * robot_.length / (robot_.top_speed * robot_.dt);
  hold_ = static_cast<std::uint32_t>(math::clamp(steps, static_cast<float>(kHold), static_cast<float>(kLongest)));
}

bool LastMetres::choose_swings(const Pose* poses) {
  if (swung_ || reach_back_ == 0.0F || goal_.facing().hitches == kInfinity) return false;
  swung_ = true;
  forget_shots(false);
  hold_ = 1;
  look_ = robot_.dt * robot_.top_speed;
  const float radius = kSwingRadius * reach_back_ / static_cast<float>(robot_.backing_body);
  radii_[kRadii] = radii_[kRadii + 1] = radius;
  Shot shot;
  shot.way = Manoeuvre::kNoWay;
  shot.backward = false;
  shot.stage = 0.0F;
  SinCos heading = math::sin_cos(goal_.facing().heading);
  const int ways = goal_.facing().either_way ? 2 : 1;
  for (int way = 0; way < ways; ++way) {
    for (shot.radius = kRadii; shot.radius < kRadii + 2; ++shot.radius) {
      const int side = swing(shot);
      const Pose end = end_of_swing(heading, side);
      for (const float turn : kSwings) {
        shot.lead = turn * radius + near_;
        shot.end = along(end, side, radius, -turn * radius);
        if (sight_.slack(shot.end.position) < 0.0F) continue;
        for (shot.word = 0; shot.word < kDubinsWords; ++shot.word) consider(poses, shot);
      }
    }
    heading = opposite(heading);
  }
  return shot_count_ > 0;
}

// On the outer side, ahead, and short of the heading: what the goal's tolerances leave shortens the way that trailers
// need.
Pose LastMetres::end_of_swing(SinCos heading, int side) const {
  const auto turn = static_cast<float>(side);
  const Vec2 ahead = kSwingAim * goal_.radius() * direction(heading);
  const SinCos tilt = math::sin_cos(turn * kSwingTilt * goal_.facing().tolerance);
  return {goal_.center() + ahead - turn * left_of(ahead), heading + tilt};
}

// A line that does not look free is refused sooner than its trailers are drawn.
bool LastMetres::allows(const Pose* poses, const Shot& shot, const CurvedLine& line) const {
  if (swing(shot) != 0) return looks_free(line) && straightens(poses, line);
  return !shot.backward || shot.length <= most_push_;
}

// Each trailer's axle follows the one before it at the same distance.
bool LastMetres::straightens(const Pose* poses, const CurvedLine& line) const {
  Vec2 axles[kMaxBodies];
  float hitches[kMaxBodies];
  const int last = robot_.backing_body;
  for (int k = 1; k <= last; ++k) {
    axles[k] = poses[k].position;
    hitches[k] = length(poses[k - 1].position - axles[k]);
  }
  const float whole = line.length();
  const float steps = whole * static_cast<float>(last) / (kDrawStep * reach_back_);
  const int count = 1 + static_cast<int>(math::clamp(steps, 0.0F, static_cast<float>(kMostSteps - 1)));
  const float allowed = kStraightEnough * goal_.facing().hitches;
  for (int i = 1; i <= count; ++i) {
    const bool ends = i == count;
    const Pose at = line.at(ends ? whole : whole * static_cast<float>(i) / static_cast<float>(count));
    Vec2 before = at.position;
    Vec2 ahead = direction(at.heading);
    for (int k = 1; k <= last; ++k) {
      const Vec2 way = before - axles[k];
      const float far = length(way);
      if (far == 0.0F) return false;
      const Vec2 along = (1.0F / far) * way;
      axles[k] = before - hitches[k] * along;
      if (dot(along, ahead) < kFold || sight_.slack(axles[k]) < 0.0F) return false;
      if (ends && math::absolute(cross(along, ahead)) > allowed) return false;
      before = axles[k];
      ahead = along;
    }
  }
  return true;
}

void LastMetres::choose_stages(const Pose* poses) {
  forget_shots(true);
  Shot shot;
  shot.way = Manoeuvre::kNoWay;
  shot.backward = false;
  shot.end.heading = math::sin_cos(goal_.facing().heading);
  const int ways = goal_.facing().either_way ? 2 : 1;
  for (int way = 0; way < ways; ++way) {
    for (const float stage : kStages) {
      shot.stage = stage * most_push_;
      shot.end.position = goal_.center() + shot.stage * direction(shot.end.heading);
      for (int lead = short_leads_; lead < kLeadCount; ++lead) {
        shot.lead = std::min(shot.stage, leads_[lead]);
        consider_words(poses, shot);
      }
    }
    shot.end.heading = opposite(shot.end.heading);
  }
}

// The line back is that which the last trailer takes where all are in line.
void LastMetres::turn_back() {
  Shot& shot = shots_[shot_ - 1];
  const Vec2 ahead = direction(shot.end.heading);
  const Vec2 tail = shot.end.position - reach_back_ * ahead;
  line_ = CurvedLine({tail, opposite(shot.end.heading)}, 1.0F);
  line_.add(0, shot.stage);
  shot.end.position = tail - shot.stage * ahead;
  shot.stage = 0.0F;
  shot.backward = true;
  arc_ = 0.0F;
}

}  // namespace krait::detail
