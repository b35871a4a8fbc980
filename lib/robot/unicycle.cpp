// SPDX-License-Identifier: Apache-2.0
#include "krait/robots/unicycle.hpp"

#include "robot/shape.hpp"
#include "robot/tracking.hpp"
#include "robot/turning.hpp"

namespace krait {

using detail::correction;
using detail::Correction;
using detail::deviation;
using detail::kHeadingShare;
using detail::positive;
using detail::speed_in_turn;

namespace {

constexpr PidGains kHeadingGains{4.0F, 0.05F, 0.05F};  // rad/s per radian of heading error

}  // namespace

bool Unicycle::sound() const {
  const UnicycleParameters& p = parameters_;
  return positive(p.body_length) && positive(p.body_width) && positive(p.max_speed) && positive(p.max_turn_rate) &&
         finite(p.min_speed) && p.min_speed <= p.max_speed;
}

void Unicycle::steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
  const UnicycleParameters& p = parameters_;
  if (target.speed == 0.0F) {
    u[0] = p.min_speed > 0.0F ? p.min_speed : 0.0F;
    u[1] = 0.0F;
    return;
  }
  const float error = heading_error(s, target);
  const float along = math::sin_cos(error).cos;
  const float top = target.speed * (target.speed < 0.0F ? -p.min_speed : p.max_speed);
  float speed = along > 0.0F ? top * along : 0.0F;
  if (target.turn < 1.0F) {
    const float turning = math::absolute(error) / p.max_turn_rate;
    speed = speed_in_turn(top, target.turn, turning, length(target.point - position(s)));
  }
  u[0] = speed > p.min_speed ? speed : p.min_speed;
  u[1] = math::clamp(steering.heading(kHeadingGains, error, target.dt), -p.max_turn_rate, p.max_turn_rate);
}

void Unicycle::track(StateView s, StateView reference, float dt, ControlRef u) const {
  const UnicycleParameters& p = parameters_;
  const Correction change = correction(deviation(s, reference), u[0], p.body_length, dt);
  u[0] = math::clamp(u[0] + change.speed, p.min_speed, p.max_speed);
  u[1] = math::clamp(u[1] + kHeadingShare * change.heading / dt, -p.max_turn_rate, p.max_turn_rate);
}

bool Unicycle::within_limits(StateView s) const { return finite(position(s)) && math::absolute(s[2]) <= kMaxAngle; }

bool Unicycle::travel(StateView, ControlView u, float dt, StateView, Travel* travel) const {
  const float path = dt * math::absolute(u[0]);
  const float turn = dt * math::absolute(u[1]);
  travel[0] = {path, turn, 0.125F * path * turn, 0.125F * turn * turn};
  return true;
}

template class detail::FunctionsOf<Unicycle>;

}  // namespace krait
