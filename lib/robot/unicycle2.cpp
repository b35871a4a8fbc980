// SPDX-License-Identifier: Apache-2.0
#include "krait/robots/unicycle2.hpp"

#include "robot/limits.hpp"
#include "robot/shape.hpp"
#include "robot/tracking.hpp"
#include "robot/turning.hpp"

namespace krait {

using detail::correction;
using detail::Correction;
using detail::deviation;
using detail::inside;
using detail::kHeadingShare;
using detail::kInside;
using detail::kSteered;
using detail::kTurnBrake;
using detail::positive;
using detail::speed_in_turn;
using detail::stoppable_turn;
using detail::turn_time;

bool Unicycle2::sound() const {
  const Unicycle2Parameters& p = parameters_;
  return positive(p.body_length) && positive(p.body_width) && positive(p.max_speed) && finite(p.min_speed) &&
         p.min_speed <= 0.0F && positive(p.max_turn_rate) && positive(p.max_acceleration) &&
         positive(p.max_turn_acceleration);
}

// Where it turns so fast that it will pass the direction behind it, it turns on and not back. Speed yields by the
// cosine's square: a machine that takes two seconds to its top speed finds its way with fewer vertices so than with the
// cosine. Where its turn need not be the sharpest it drives on while it turns, as if it turned from rest to rest.
void Unicycle2::steer(StateView s, const Target& target, Steering&, ControlRef u) const {
  const Unicycle2Parameters& p = parameters_;
  if (target.speed == 0.0F) {
    approach(s, 0.0F, 0.0F, kSteered, target.dt, u);
    return;
  }
  const float error = heading_error(s, target);
  const float along = math::sin_cos(error).cos;
  const float stopped = error - 0.5F * s[4] * math::absolute(s[4]) / (kSteered * p.max_turn_acceleration);
  const float around = stopped > kPi ? error - 2.0F * kPi : stopped < -kPi ? error + 2.0F * kPi : error;
  const float remaining = around - 0.5F * s[4] * target.dt;
  const float rate = stoppable_turn(remaining, kTurnBrake * p.max_turn_acceleration, target.dt);
  const float top = target.speed * (target.speed < 0.0F ? -p.min_speed : p.max_speed);
  float speed = along > 0.0F ? top * along * along : 0.0F;
  if (target.turn < 1.0F) {
    const float turning = turn_time(math::absolute(around), p.max_turn_rate, kSteered * p.max_turn_acceleration);
    speed = speed_in_turn(top, target.turn, turning, length(target.point - position(s)));
  }
  approach(s, speed, remaining < 0.0F ? -rate : rate, kSteered, target.dt, u);
}

// The control that brings speed and turn rate as near to the wanted ones as their limits and `share` of the
// accelerations allow in a time step. A slow machine is steered with as much of them as there is for seconds on end.
// Were that all, its plan could be turned to the tree's way in one direction only, and would sway away from it.
void Unicycle2::approach(StateView s, float speed, float turn_rate, float share, float dt, ControlRef u) const {
  const Unicycle2Parameters& p = parameters_;
  const float most = p.max_turn_rate * kInside;
  const float push = share * p.max_acceleration;
  const float twist = share * p.max_turn_acceleration;
  u[0] = math::clamp((inside(speed, p.min_speed, p.max_speed) - s[3]) / dt, -push, push);
  u[1] = math::clamp((math::clamp(turn_rate, -most, most) - s[4]) / dt, -twist, twist);
}

void Unicycle2::track(StateView s, StateView reference, float dt, ControlRef u) const {
  const float speed = reference[3];
  const Correction change = correction(deviation(s, reference), speed, parameters_.body_length, dt);
  approach(s, speed + u[0] * dt + change.speed, reference[4] + u[1] * dt + kHeadingShare * change.heading / dt, 1.0F,
           dt, u);
}

float Unicycle2::stopping_way(StateView s) const {
  return 0.5F * s[3] * math::absolute(s[3]) / (kSteered * parameters_.max_acceleration);
}

bool Unicycle2::within_limits(StateView s) const {
  const Unicycle2Parameters& p = parameters_;
  return finite(position(s)) && math::absolute(s[2]) <= kMaxAngle && s[3] >= p.min_speed && s[3] <= p.max_speed &&
         math::absolute(s[4]) <= p.max_turn_rate;
}

// With x = h r, r the heading's rate, a step of h whose speed changes by d is off by at most some (|v| x^4 + d x^3) h.
// Speed that changes by much more than x |v| makes the rate a little larger, so that d x^3 is no more than |v| x^4.
float Unicycle2::fastest_rate(float dt) const {
  const Unicycle2Parameters& p = parameters_;
  const float whole = 2.0F * p.max_turn_rate / dt;
  const float acceleration = p.max_turn_acceleration < whole ? p.max_turn_acceleration : whole;
  const float turning = 0.5F * p.max_turn_rate;
  const float twisting = std::sqrt(0.5F * acceleration);
  const float heading = turning > twisting ? turning : twisting;
  const float fastest = extremes().speed;
  const float range = (p.max_speed - p.min_speed) / dt;
  const float hurry = (p.max_acceleration < range ? p.max_acceleration : range) / (fastest * heading);
  return hurry > 1.0F ? heading * std::sqrt(std::sqrt(hurry)) : heading;
}

// Speed v and turn rate w are linear in time, so |v| and |w| are convex: each is at most the larger of its values at
// the step's ends, and its integral, the way or the turn, at most their mean times dt. The position is accelerated by
// u[0] along the heading and by v w across it.
bool Unicycle2::travel(StateView s, ControlView u, float dt, StateView, Travel* travel) const {
  float mean[2];
  float most[2];
  for (int i = 0; i < 2; ++i) {
    const float before = math::absolute(s[3 + i]);
    const float after = math::absolute(s[3 + i] + u[i] * dt);
    mean[i] = dt * 0.5F * (before + after);
    most[i] = dt * (before > after ? before : after);
  }
  const float forward = dt * dt * math::absolute(u[0]);
  const float sideways = dt * dt * math::absolute(u[1]);
  travel[0] = {mean[0], mean[1], 0.125F * (forward + most[0] * most[1]), 0.125F * (sideways + most[1] * most[1])};
  return true;
}

template class detail::FunctionsOf<Unicycle2>;

}  // namespace krait
