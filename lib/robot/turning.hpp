// SPDX-License-Identifier: Apache-2.0
// How robots are steered that turn on the spot and whose speeds change at bounded rates, which may take seconds.
#pragma once

#include "krait/geometry.hpp"

namespace krait::detail {

inline constexpr float kSteered = 0.98F;   // of the largest accelerations: what steering takes; tracking has the rest,
                                           // too, without which plans sway away from the tree
inline constexpr float kTurnBrake = 0.7F;  // of the largest turn acceleration: what turning is to be stopped with

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

}  // namespace krait::detail
