// SPDX-License-Identifier: Apache-2.0
#include "last_metres/docking.hpp"

#include "krait/robots/detail/functions.hpp"
#include "last_metres/arc.hpp"
#include "last_metres/last_metres.hpp"

namespace krait::detail {
namespace {

// Measured: bench/ABLATIONS.md, "Trucks dock".
constexpr float kHoldWay = 0.6F;     // lengths of body 0 that a leg goes at the top speed, at least
constexpr float kPushLook = 1.125F;  // how far ahead of the last trailer it steers, in distances from body 0 to that
constexpr float kMostPush = 6.5F;    // hitch lengths that it pushes, at most: then, of three trailers, what rounding
                                     // leaves has grown as large as a plan's proof allows
constexpr float kStages[] = {0.5F, 0.8F, 0.9F, 1.0F};  // of these: how far ahead of the pose it pulls them straight

void measure(LastMetres& last_metres, const Pose* poses) { last_metres.measure_push(poses); }
void choose(LastMetres& last_metres, const Pose* poses) { last_metres.choose_stages(poses); }
void turn_back(LastMetres& last_metres) { last_metres.turn_back(); }

}  // namespace

const Docking kDocking = {measure, choose, turn_back};

void LastMetres::measure_push(const Pose* poses) {
  const int last = robot_.backing_body;
  reach_back_ = 0.0F;
  for (int k = 0; k < last; ++k) reach_back_ = reach_back_ + length(poses[k + 1].position - poses[k].position);
  most_push_ = kMostPush * reach_back_ / static_cast<float>(last);
  push_look_ = kPushLook * reach_back_;
  const float steps = kHoldWay * robot_.length / (robot_.top_speed * robot_.dt);
  hold_ = static_cast<std::uint32_t>(math::clamp(steps, static_cast<float>(kHold), static_cast<float>(kLongest)));
}

void LastMetres::choose_stages(const Pose* poses) {
  forget_shots(true);
  Shot shot;
  shot.way = PullIn::kNoWay;
  shot.backward = false;
  shot.end.heading = math::sin_cos(goal_.facing().heading);
  const int ways = goal_.facing().either_way ? 2 : 1;
  for (int way = 0; way < ways; ++way) {
    for (const float stage : kStages) {
      shot.stage = stage * most_push_;
      shot.end.position = goal_.center() + shot.stage * direction(shot.end.heading);
      for (int lead = short_leads_; lead < kLeadCount; ++lead) {
        shot.lead = leads_[lead] < shot.stage ? leads_[lead] : shot.stage;
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
