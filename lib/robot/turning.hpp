// SPDX-License-Identifier: Apache-2.0
// How robots are steered that turn on the spot. Their speeds may change at bounded rates, which may take seconds.
#pragma once

#include "krait/robots/model.hpp"

namespace krait::detail {

// Found by driving, and part of the models: lib/robot/UNICYCLE2.md and DIFF_DRIVE.md, "Steering".
inline constexpr float kSteered = 0.98F;   // of the largest accelerations: what steering takes; tracking has the rest,
                                           // too, without which plans sway away from the tree
inline constexpr float kTurnBrake = 0.7F;  // of the largest turn acceleration: what turning is to be stopped with
inline constexpr float kTurnTimes = 2.5F;  // times as long as its nearly sharpest turn a way to the target takes

// The most turn rate w toward a heading after a step of dt such that turning can be stopped there with `brake` rad/s^2:
// in the step it turns by (omega + w) dt / 2, and then by less than w^2 / (2 brake) + w dt / 2. So w is the root of
// w^2 / (2 brake) + w dt = remaining, the heading's error less omega dt / 2, which leaves no error after two steps
// where brake is no limit. rad/s, at least 0.
inline float stoppable_turn(float remaining, float brake, float dt) {
  const float step = brake * dt;
  return std::sqrt(step * step + 2.0F * brake * math::absolute(remaining)) - step;
}

// Seconds that a turn by `angle`, at least 0, takes from rest to rest.
inline float turn_time(float angle, float most_rate, float acceleration) {
  const bool slow = acceleration * angle < most_rate * most_rate;
  return slow ? 2.0F * std::sqrt(angle / acceleration) : angle / most_rate + most_rate / acceleration;
}

// The speed toward a target in m/s where the turn toward it need not be the sharpest: the robot drives on while it
// turns, so fast that its way, in metres, takes kTurnTimes and its squared share of the sharpest turn times as long as
// the turn, in seconds. It is at most `top`, and has its sign.
inline float speed_in_turn(float top, float share, float turning, float way) {
  const float slowed = kTurnTimes * share * share * turning * math::absolute(top);
  return way < slowed ? top * (way / slowed) : top;
}

}  // namespace krait::detail
