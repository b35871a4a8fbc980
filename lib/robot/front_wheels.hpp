// SPDX-License-Identifier: Apache-2.0
// How the front wheels of a car are steered toward a point and back to a reference's line.
#pragma once

#include "robot/tracking.hpp"

namespace krait::detail {

// Radians of steering per radian of heading error. Found by driving, and part of the models: lib/robot/SNAKE.md,
// "Steering".
inline constexpr PidGains kSteeringGains{4.0F, 0.05F, 0.05F};

// Radians that the wheels must be turned over by: the heading's error to the point, backwards that of the rear, on the
// side to which the wheels then turn.
[[gnu::always_inline]] inline float wheels_error(StateView s, SinCos heading, Vec2 point, bool backward) {
  const Vec2 to{point.x - s[0], point.y - s[1]};
  const Vec2 along{heading.cos, heading.sin};
  return backward ? -math::atan2(-cross(along, to), -dot(along, to)) : math::atan2(cross(along, to), dot(along, to));
}

// The steering angle nearest to the wanted one within the lock, either way, and `side` toward the wanted side.
[[gnu::always_inline]] inline float within_lock(float wanted, float side, float lock) {
  return wanted < 0.0F ? math::clamp(wanted, -math::clamp(side, -lock, lock), lock)
                       : math::clamp(wanted, -lock, math::clamp(side, -lock, lock));
}

// What removes a car's deviations, to be added.
struct WheelCorrection {
  float speed;     // metres a second
  float steering;  // radians
};

// The car follows its reference's line; curvature changes by what turns it over within half a dozen wheelbases, and
// the steering angle by the wheelbase times that.
[[gnu::always_inline]] inline WheelCorrection wheel_correction(const Deviation& from, float speed, float wheelbase,
                                                               float dt) {
  const float distance = 4.0F * wheelbase;
  const Correction change = correction(from, speed, distance, dt);
  const float bend = wheelbase * 4.0F * change.heading / tracking_distance(speed, distance, dt);
  return {change.speed, speed < 0.0F ? -bend : bend};
}

}  // namespace krait::detail
