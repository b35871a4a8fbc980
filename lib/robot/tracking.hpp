// SPDX-License-Identifier: Apache-2.0
// What models have in common that follow a reference motion which they are very near to.
#pragma once

#include <algorithm>

#include "krait/robots/model.hpp"

namespace krait::detail {

// How far a state is from its reference, seen from the reference.
struct Deviation {
  float ahead;     // metres
  float sideways;  // metres, to the left
  float heading;   // radians
};

// How far a state is off its reference; both begin with x, y and a heading.
inline Deviation deviation(StateView s, StateView reference) {
  const SinCos heading = math::sin_cos(reference[2]);
  const Vec2 along{heading.cos, heading.sin};
  const Vec2 apart{s[0] - reference[0], s[1] - reference[1]};
  return {dot(along, apart), cross(along, apart), s[2] - reference[2]};
}

// Share of a heading's error that a time step removes, where nothing steers. Found by driving: lib/DESIGN.md,
// "Integration".
inline constexpr float kHeadingShare = 0.2F;

// What removes deviations (lib/DESIGN.md, "Integration"): speed by a tenth of what lags a time step, heading toward the
// reference's line, so that what remains of it shrinks within `distance` metres.
struct Correction {
  float speed;    // metres a second, to be added
  float heading;  // radians, by which the heading should change
};

// Metres: `distance`, or the way of some time steps where that is more.
inline float tracking_distance(float speed, float distance, float dt) {
  constexpr float kSteps = 8.0F;  // with fewer tracking would not be stable; found by driving
  const float way = math::absolute(speed) * dt;
  return std::max(kSteps * way, distance);
}

inline Correction correction(const Deviation& from, float speed, float distance, float dt) {
  constexpr float kShare = 0.1F;  // of what lags, that a time step makes up for: lib/DESIGN.md, "Integration"
  const float turn = from.sideways / tracking_distance(speed, distance, dt);
  return {-kShare * from.ahead / dt, (speed < 0.0F ? turn : -turn) - from.heading};
}

}  // namespace krait::detail
