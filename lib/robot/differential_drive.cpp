// SPDX-License-Identifier: Apache-2.0
#include "krait/robots/differential_drive.hpp"

#include <algorithm>

#include "robot/limits.hpp"
#include "robot/shape.hpp"
#include "robot/tracking.hpp"
#include "robot/turning.hpp"

namespace krait {

using detail::correction;
using detail::Correction;
using detail::deviation;
using detail::kHeadingShare;
using detail::kInside;
using detail::kSteered;
using detail::kTurnBrake;
using detail::positive;
using detail::stoppable_turn;

namespace {

// rad/s per radian of heading error. Found by driving, and part of the model: lib/robot/DIFF_DRIVE.md, "Steering".
constexpr PidGains kHeadingGains{3.0F, 0.05F, 0.1F};
// Share of the speed by which a robot that lags may be faster. Measured: bench/ABLATIONS.md, "Plans are driven once
// more".
constexpr float kCatchUp = 0.1F;
// Metres a second by which it may be faster at any speed, since a share of no speed is none: lib/DESIGN.md,
// "Integration".
constexpr float kCreep = 1e-3F;

// The wheels' speeds after a step in which each changes by `change` at most: half their difference comes as near as
// that allows to half_turn, and their mean, by what then remains, to `forward`.
void turn_first(StateView s, float forward, float half_turn, float change, float* wheels) {
  const float turned = math::clamp(half_turn - 0.5F * (s[4] - s[3]), -change, change);
  const float rest = change - math::absolute(turned);
  const float driven = math::clamp(forward - 0.5F * (s[3] + s[4]), -rest, rest);
  wheels[0] = s[3] + (driven - turned);
  wheels[1] = s[4] + (driven + turned);
}

}  // namespace

bool DifferentialDrive::sound() const {
  const DifferentialDriveParameters& p = parameters_;
  return positive(p.body_length) && positive(p.body_width) && positive(p.wheel_radius) && positive(p.track_width) &&
         positive(p.max_wheel_speed) && positive(p.max_wheel_acceleration);
}

// Wanted speed and turn rate become wheel speeds; where a wheel would be too fast, or would have to be accelerated too
// much, speed yields to turning.
void DifferentialDrive::steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
  const DifferentialDriveParameters& p = parameters_;
  if (target.speed == 0.0F) {
    constexpr float kStill[2] = {0.0F, 0.0F};
    approach(s, kStill, 1.0F, target.dt, u);
    return;
  }
  const float error = heading_error(s, target);
  const float along = math::sin_cos(error).cos;
  const float most = p.max_wheel_speed * kInside;
  const float per_wheel = 2.0F * p.wheel_radius / p.track_width;
  const float remaining = error - 0.25F * (s[4] - s[3]) * per_wheel * target.dt;
  const float fastest = stoppable_turn(remaining, kTurnBrake * p.max_wheel_acceleration * per_wheel, target.dt);
  const float turn = math::clamp(steering.heading(kHeadingGains, error, target.dt), -fastest, fastest);
  const float half_turn = math::clamp(turn * 0.5F * p.track_width / p.wheel_radius, -most, most);
  const float room = most - math::absolute(half_turn);
  const float forward = math::clamp(target.speed * most * std::max(0.0F, along), -room, room);
  float wheels[2];
  turn_first(s, forward, half_turn, kSteered * p.max_wheel_acceleration * target.dt, wheels);
  approach(s, wheels, kSteered, target.dt, u);
}

// The control that brings the wheels' speeds as near to the wanted ones as their limit and `share` of the accelerations
// allow in a time step.
void DifferentialDrive::approach(StateView s, const float* wanted, float share, float dt, ControlRef u) const {
  const DifferentialDriveParameters& p = parameters_;
  const float most = p.max_wheel_speed * kInside;
  const float push = share * p.max_wheel_acceleration;
  for (int wheel = 0; wheel < 2; ++wheel) {
    u[wheel] = math::clamp((math::clamp(wanted[wheel], -most, most) - s[3 + wheel]) / dt, -push, push);
  }
}

// Where a wheel would be too fast, catching up yields to turning. What lags far catches up by a tenth of the
// reference's speed at most, so that it comes to rest where the reference does, and does not drive on.
void DifferentialDrive::track(StateView s, StateView reference, float dt, ControlRef u) const {
  const DifferentialDriveParameters& p = parameters_;
  const float speed = 0.5F * p.wheel_radius * (reference[3] + reference[4]);
  const Correction change = correction(deviation(s, reference), speed, p.body_length, dt);
  const float half_turn = 0.5F * p.track_width * kHeadingShare * change.heading / (dt * p.wheel_radius);
  float wanted[2] = {reference[3] + u[0] * dt - half_turn, reference[4] + u[1] * dt + half_turn};
  const float most = p.max_wheel_speed * kInside;
  const float reach = std::max(kCatchUp * math::absolute(speed), kCreep);
  const float faster = math::clamp(change.speed, -reach, reach) / p.wheel_radius;
  const float least = -most - std::min(wanted[0], wanted[1]);
  const float kept = std::min(std::max(faster, least), most - std::max(wanted[0], wanted[1]));
  for (float& wheel : wanted) wheel += kept;
  approach(s, wanted, 1.0F, dt, u);
}

bool DifferentialDrive::within_limits(StateView s) const {
  const float most = parameters_.max_wheel_speed;
  return finite(position(s)) && math::absolute(s[2]) <= kMaxAngle && math::absolute(s[3]) <= most &&
         math::absolute(s[4]) <= most;
}

// Each wheel stops by itself.
float DifferentialDrive::stopping_way(StateView s) const {
  const DifferentialDriveParameters& p = parameters_;
  const float turned =
      s[3] * math::absolute(s[3]) + s[4] * math::absolute(s[4]);  // times twice the acceleration, of both wheels
  return 0.25F * p.wheel_radius * turned / p.max_wheel_acceleration;
}

float DifferentialDrive::fastest_rate(float dt) const {
  const DifferentialDriveParameters& p = parameters_;
  const float per_wheel = 2.0F * p.wheel_radius / p.track_width;  // of two wheels that turn against each other
  const float whole = 2.0F * p.max_wheel_speed / dt;
  const float acceleration = std::min(whole, p.max_wheel_acceleration);
  const float turning = 0.5F * per_wheel * p.max_wheel_speed;
  const float twisting = std::sqrt(0.5F * per_wheel * acceleration);
  return std::max(twisting, turning);
}

// The wheels' speeds are linear in time, and so are their mean, at which the axle's middle moves, and their difference,
// at which over the track the body turns: each is at most the larger of its values at the step's ends.
bool DifferentialDrive::travel(StateView s, ControlView u, float dt, StateView, Travel* travel) const {
  const float step = dt * parameters_.wheel_radius;
  const float ahead = s[3] + s[4];
  const float apart = s[4] - s[3];
  const float faster = (u[0] + u[1]) * dt;
  const float turning = (u[1] - u[0]) * dt;
  const float path = 0.5F * step * std::max(math::absolute(ahead), math::absolute(ahead + faster));
  const float turn = step / parameters_.track_width * std::max(math::absolute(apart), math::absolute(apart + turning));
  const float forward = 0.5F * step * math::absolute(faster);
  const float sideways = step / parameters_.track_width * math::absolute(turning);
  travel[0] = {path, turn, 0.125F * (forward + path * turn), 0.125F * (sideways + turn * turn)};
  return true;
}

template class detail::FunctionsOf<DifferentialDrive>;

}  // namespace krait
