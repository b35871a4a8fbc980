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
  const float side = backward ? -1.0F : 1.0F;
  return side * math::atan2(side * cross(along, to), side * dot(along, to));
}

// The wheels of a moving car: radians that they are turned by, metres a second, metres, radians a second and seconds.
struct TurningWheels {
  float angle;
  float speed;
  float wheelbase;
  float rate;
  float dt;
};

// The steering angle nearest to the wanted one, toward the side of a heading `error` radians away, from which the
// wheels can be straight again soon after that is reached. At an angle psi the car turns by k psi a second, k = speed /
// wheelbase: over the step by the mean of the present angle and psi, and then, while the wheels turn back at `rate`, by
// k psi^2 / (2 rate). It may pass the heading by a quarter of what the wheels turn by while it drives a wheelbase,
// rate / k. So psi is at most the root of psi^2 / (2 rate) + psi dt / 2 = (|error| + rate / (4 k)) / k less the present
// angle's half of the step. Where the car hardly moves, any angle will do.
inline float straightenable(float wanted, float error, const TurningWheels& wheels) {
  constexpr float kPast = 0.25F;   // measured: bench/ABLATIONS.md, "Wheels are straight again in time"
  constexpr float kCreep = 1e-3F;  // wheelbases a step: a slower car hardly moves; keeps the divisions below from zero
  const float way = std::max(kCreep, math::absolute(wheels.speed) * wheels.dt / wheels.wheelbase);
  const float step = wheels.rate * wheels.dt;
  const float toward = error < 0.0F ? -wheels.angle : wheels.angle;
  const float remaining = (math::absolute(error) + kPast * step / way) / way - 0.5F * toward;
  const float most = std::sqrt(0.25F * step * step + 2.0F * step * std::max(0.0F, remaining)) - 0.5F * step;
  return error < 0.0F ? math::clamp(wanted, -most, 0.0F) : math::clamp(wanted, 0.0F, most);
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
