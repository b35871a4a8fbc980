// SPDX-License-Identifier: Apache-2.0
// A robot that keeps every promise of the concept, and all the ways in which it may break one: one at a time.
#pragma once

#include <cmath>
#include <string>

#include "krait/robot_check.hpp"
#include "krait/robots/truck.hpp"

namespace krait::test {

enum class Wrong {
  nothing,
  derivative_nan,
  derivative_counts_its_calls,
  derivative_leaves_a_rate_unwritten,
  derivative_depends_on_the_place,
  derivative_mixes_sine_and_cosine,
  derivative_leaps_to_and_fro,
  limits_count_their_calls,
  limits_depend_on_the_place,
  limits_nowhere,
  body_grows,
  body_clockwise,
  place_nan_heading_of_the_second_body,
  place_long_heading,
  place_short_heading,
  place_off_the_position,
  place_leaps,
  place_leaves_a_frame_unwritten,
  place_keeps_to_the_north,
  travel_negative,
  travel_nan,
  travel_leaves_a_body_unwritten,
  travel_path_too_small,
  travel_turn_too_small,
  travel_bend_too_small,
  travel_twist_too_small,
  travel_vouches_for_limits_that_break,
  travel_depends_on_the_heading,
  quick_path_too_small,
  quick_negative,
  quick_separation_too_large,
  quick_separation_nan,
  quick_vouches_for_limits_that_break,
  steer_beyond_its_limits,
  steer_below_its_limits,
  steer_nan_at_the_target,
  steer_too_fast,
  steer_counts_its_calls,
  steer_remembers_its_calls,
  steer_never_brakes,
  speed_is_never_0,
  rate_too_small,
  rate_nan
};

// A cart that drives forwards and turns, and a box behind it on a stiff bar of a metre. State (x, y, heading, speed),
// control (acceleration, turn rate); speeds between 0.7 and 0.72 m/s are beyond the limits of some wrong ones.
class Cart {
 public:
  static constexpr int kMaxState = 4, kMaxControl = 2, kMaxBodies = 2;
  static constexpr float kSpeed = 1.5F, kAcceleration = 3.0F, kTurnRate = 2.0F;

  explicit Cart(Wrong wrong = Wrong::nothing) : wrong_(wrong) {}

  int state_size() const { return 4; }
  int control_size() const { return 2; }
  int body_count() const { return 2; }
  int self_collision_gap() const { return 1; }

  void derivative(StateView s, ControlView u, StateRef ds) const {
    const SinCos heading = math::sin_cos(s[2]);
    ds[0] = s[3] * (is(Wrong::derivative_mixes_sine_and_cosine) ? heading.sin : heading.cos);
    ds[1] = s[3] * heading.sin;
    ds[2] = u[1];
    if (!is(Wrong::derivative_leaves_a_rate_unwritten)) ds[3] = u[0];
    if (is(Wrong::derivative_nan) && s[3] > 1.0F) ds[1] = kInfinity - kInfinity;
    if (is(Wrong::derivative_counts_its_calls)) ds[2] += 0.001F * static_cast<float>(++calls_ % 3);
    if (is(Wrong::derivative_depends_on_the_place)) ds[2] += 0.1F * s[0];
    if (is(Wrong::derivative_leaps_to_and_fro)) ds[2] += math::sin_cos(3000.0F * s[2]).sin > 0.0F ? 5.0F : -5.0F;
  }

  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
    const SinCos heading = math::sin_cos(s[2]);
    const Vec2 to = target.point - position(s);
    const Vec2 along{heading.cos, heading.sin};
    const float turn = 2.0F * math::atan2(cross(along, to), dot(along, to)) * target.turn;
    const float most = is(Wrong::steer_beyond_its_limits) ? 2.0F * kTurnRate : kTurnRate;
    const float least = is(Wrong::steer_below_its_limits) ? -2.0F * kTurnRate : -most;
    u[1] = math::clamp(turn, least, most);
    const float share = is(Wrong::steer_never_brakes) ? math::clamp(target.speed, 0.5F, 1.0F) : target.speed;
    const float speed = share * kSpeed * (is(Wrong::steer_too_fast) ? 1.1F : 0.999F);
    u[0] = math::clamp((speed - s[3]) / target.dt, -kAcceleration, kAcceleration);
    if (is(Wrong::steer_nan_at_the_target)) u[1] = 0.1F * to.x / length(to);
    if (is(Wrong::steer_counts_its_calls)) u[1] = 0.001F * static_cast<float>(++calls_ % 3);
    if (is(Wrong::steer_remembers_its_calls)) {
      u[1] = steering.heading({0.0F, 0.001F, 0.0F}, 0.0F, target.dt);
      steering.heading({}, static_cast<float>(++calls_ % 3), target.dt);
    }
  }

  bool within_limits(StateView s) const {
    if (is(Wrong::limits_nowhere)) return false;
    if (is(Wrong::limits_count_their_calls) && ++calls_ % 3 == 0) return false;
    if (is(Wrong::limits_depend_on_the_place) && s[0] > 2.0F) return false;
    if (breaks_limits() && s[3] > 0.7F && s[3] < 0.72F) return false;
    return s[3] >= 0.0F && s[3] <= kSpeed && finite(position(s)) && math::absolute(s[2]) < 1000.0F;
  }

  Polygon body(int) const {
    static constexpr Vec2 kBox[] = {{-0.3F, -0.2F}, {0.3F, -0.2F}, {0.3F, 0.2F}, {-0.3F, 0.2F}};
    static constexpr Vec2 kGrown[] = {{-0.4F, -0.2F}, {0.3F, -0.2F}, {0.3F, 0.2F}, {-0.4F, 0.2F}};
    static constexpr Vec2 kClockwise[] = {{-0.3F, 0.2F}, {0.3F, 0.2F}, {0.3F, -0.2F}, {-0.3F, -0.2F}};
    if (is(Wrong::body_clockwise)) return {kClockwise, 4};
    return {is(Wrong::body_grows) && ++calls_ % 2 == 0 ? kGrown : kBox, 4};
  }

  void place(StateView s, Pose* poses) const {
    const SinCos heading = is(Wrong::place_keeps_to_the_north) ? SinCos{1.0F, 0.0F} : math::sin_cos(s[2]);
    const Vec2 behind = position(s) - Vec2{heading.cos, heading.sin};
    poses[0] = {position(s), heading};
    if (!is(Wrong::place_leaves_a_frame_unwritten)) poses[1] = {behind, heading};
    if (is(Wrong::place_nan_heading_of_the_second_body) && s[3] > 1.0F) poses[1].heading.cos = std::nanf("");
    if (is(Wrong::place_long_heading)) poses[1].heading.sin *= 1.01F;
    if (is(Wrong::place_short_heading)) poses[1].heading = {0.5F * heading.sin, 0.5F * heading.cos};
    if (is(Wrong::place_off_the_position)) poses[0].position.x += 0.25F;
    if (is(Wrong::place_leaps) && s[3] > 1.0F) poses[1].position.y += 0.5F;
  }

  bool travel(StateView s, ControlView u, float dt, StateView, Travel* travel) const {
    const float way = dt * fastest(s, u, dt);
    const float turn = dt * math::absolute(u[1]);
    const float bend = 0.125F * (dt * dt * math::absolute(u[0]) + way * turn);
    travel[0] = {way, turn, bend, 0.125F * turn * turn};
    if (!is(Wrong::travel_leaves_a_body_unwritten)) {
      travel[1] = {way + turn, turn, bend + 0.125F * turn * turn, 0.125F * turn * turn};
    }
    if (is(Wrong::travel_negative)) travel[1].turn = -turn - 0.01F;
    if (is(Wrong::travel_nan)) travel[1].bend = std::nanf("");
    if (is(Wrong::travel_path_too_small)) travel[1].path = way;
    if (is(Wrong::travel_turn_too_small)) travel[0].turn *= 0.9F;
    if (is(Wrong::travel_bend_too_small)) travel[1].bend = bend;
    if (is(Wrong::travel_twist_too_small)) travel[0].twist = 0.0F;
    if (is(Wrong::travel_depends_on_the_heading)) travel[0].path *= 1.0F + math::absolute(math::sin_cos(s[2]).sin);
    return !is(Wrong::quick_vouches_for_limits_that_break);
  }

  QuickBound quick_bound(StateView s, ControlView u, float dt, StateView next) const {
    Travel each[2] = {};
    travel(s, u, dt, next, each);
    QuickBound bound{!is(Wrong::travel_vouches_for_limits_that_break), 0.99F, each[1]};
    if (is(Wrong::quick_path_too_small)) bound.most.path = 0.5F * each[0].path;
    if (is(Wrong::quick_negative)) bound.most.twist = -1.0F;
    if (is(Wrong::quick_separation_too_large)) bound.separation = 1.1F;
    if (is(Wrong::quick_separation_nan)) bound.separation = std::nanf("");
    return bound;
  }

  float speed(StateView s) const { return is(Wrong::speed_is_never_0) ? 0.1F : s[3]; }

  float fastest_rate(float) const {
    return is(Wrong::rate_nan) ? std::nanf("") : is(Wrong::rate_too_small) ? 0.1F : 2.0F;
  }

 private:
  bool is(Wrong wrong) const { return wrong_ == wrong; }
  bool breaks_limits() const {
    return is(Wrong::travel_vouches_for_limits_that_break) || is(Wrong::quick_vouches_for_limits_that_break);
  }
  static float fastest(StateView s, ControlView u, float dt) {
    const float after = math::absolute(s[3] + dt * u[0]);
    return after > math::absolute(s[3]) ? after : math::absolute(s[3]);
  }

  Wrong wrong_;
  mutable unsigned calls_ = 0;
};

inline RobotRanges cart_ranges() {
  RobotRanges ranges;
  ranges.state = {{-10, 10}, {-10, 10}, {-3, 3}, {0, Cart::kSpeed}};
  ranges.control = {{-Cart::kAcceleration, Cart::kAcceleration}, {-Cart::kTurnRate, Cart::kTurnRate}};
  ranges.dt = {0.05F, 0.1F, 0.4F};
  ranges.headings = {2};
  ranges.step_rate = 0.5F;
  ranges.step_error = 1e-4F;
  return ranges;
}

enum class WrongFront {
  nothing,
  size,
  derivative,
  place,
  place_alone,
  lead_step,
  rest_step,
  lead_alone,
  rest_unwritten
};

// A truck whose leading components or own integration may be wrong.
class FrontTruck : public Truck {
 public:
  FrontTruck(const ChainParameters& parameters, WrongFront wrong) : Truck(parameters), wrong_(wrong) {}

  int leading_size() const { return is(WrongFront::size) ? 99 : kCarState; }
  void derivative(StateView s, ControlView u, StateRef ds) const {
    Truck::derivative(s, u, ds);
    if (is(WrongFront::derivative) && s.size() > kCarState) ds[2] += 0.1F * s[5];
  }
  void place(StateView s, Pose* poses) const {
    Truck::place(s, poses);
    if (is(WrongFront::place)) poses[1] = poses[0];
    if (is(WrongFront::place_alone) && s.size() == kCarState) poses[0].position.x += 0.001F;
  }
  void integrate_lead(StateView s, const Pose* poses, ControlView u, float dt, Lead& lead, float* d) const {
    Truck::integrate_lead(s, poses, u, dt, lead, d);
    if (is(WrongFront::lead_step)) d[0] += 0.001F;
    if (is(WrongFront::lead_alone) && s.size() == kCarState) d[0] *= 1.00001F;
  }
  void integrate_rest(StateView s, const Pose* poses, float dt, const Lead& lead, float* d) const {
    const float before = s.size() > kCarState ? d[kCarState] : 0.0F;
    Truck::integrate_rest(s, poses, dt, lead, d);
    if (is(WrongFront::rest_step)) d[kCarState] *= 1.01F;
    if (is(WrongFront::rest_unwritten)) d[kCarState] = before;
  }

 private:
  bool is(WrongFront wrong) const { return wrong_ == wrong; }
  WrongFront wrong_;
};

}  // namespace krait::test
