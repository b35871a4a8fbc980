// SPDX-License-Identifier: Apache-2.0
// A robot that a user writes: a square that slides in any direction at up to `max_speed`.
#pragma once

#include "krait/geometry.hpp"
#include "krait/robot.hpp"

namespace krait::test {

class Slider {
 public:
  static constexpr int kMaxState = 2, kMaxControl = 2, kMaxBodies = 1;

  Slider(float side, float max_speed) : max_speed_(max_speed) { rectangle(side, side, 0.0F, square_); }

  int state_size() const { return 2; }
  int control_size() const { return 2; }
  int body_count() const { return 1; }
  void derivative(StateView, ControlView u, StateRef ds) const { ds = u; }
  void steer(StateView s, const Target& target, Steering&, ControlRef u) const {
    const Vec2 to = target.point - position(s);
    const float gain = target.speed * max_speed_ / (length(to) + 1e-3F);
    u << gain * to.x, gain * to.y;
  }
  bool within_limits(StateView s) const { return finite(position(s)); }
  Polygon body(int) const { return {square_, 4}; }
  void place(StateView s, Pose* poses) const { poses[0] = {position(s), {0.0F, 1.0F}}; }
  bool travel(StateView, ControlView u, float dt, StateView, Travel* travel) const {
    travel[0] = {dt * length({u[0], u[1]}), 0.0F, 0.0F, 0.0F};
    return true;
  }

 private:
  float max_speed_;
  Vec2 square_[4];
};

// The same robot, which states its rates instead of its travel.
class RatedSlider {
 public:
  static constexpr int kMaxState = 2, kMaxControl = 2, kMaxBodies = 1;

  RatedSlider(float side, float max_speed) : slider_(side, max_speed) {}

  int state_size() const { return 2; }
  int control_size() const { return 2; }
  int body_count() const { return 1; }
  void derivative(StateView s, ControlView u, StateRef ds) const { slider_.derivative(s, u, ds); }
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const {
    slider_.steer(s, target, steering, u);
  }
  bool within_limits(StateView s) const { return slider_.within_limits(s); }
  Polygon body(int k) const { return slider_.body(k); }
  void place(StateView s, Pose* poses) const { slider_.place(s, poses); }
  bool rates(StateView, ControlView u, float, StateView, BodyRates* rates) const {
    rates[0] = {length({u[0], u[1]}), 0.0F, 0.0F, 0.0F};
    return true;
  }

 private:
  Slider slider_;
};

}  // namespace krait::test
