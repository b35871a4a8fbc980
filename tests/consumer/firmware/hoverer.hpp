// SPDX-License-Identifier: Apache-2.0
// The firmware's own robot: a hovering box, pushed along x and y. State x y vx vy, control the accelerations.
#pragma once

#include "krait/krait.hpp"

struct Hoverer {
  static constexpr int kMaxState = 4, kMaxControl = 2, kMaxBodies = 1;
  int state_size() const { return 4; }
  int control_size() const { return 2; }
  int body_count() const { return 1; }
  void derivative(krait::StateView s, krait::ControlView u, krait::StateRef ds) const { ds << s.tail(2), u; }
  void steer(krait::StateView s, const krait::Target& target, krait::Steering&, krait::ControlRef u) const {
    const krait::Vec2 to = target.point - krait::position(s);
    const float speed = target.speed / (krait::length(to) + 0.1F);
    for (int i = 0; i < 2; ++i)
      u[i] = krait::math::clamp(5.0F * (speed * (i == 0 ? to.x : to.y) - s[2 + i]), -2.0F, 2.0F);
  }
  bool within_limits(krait::StateView s) const { return s.tail(2).squaredNorm() <= 2.0F; }
  krait::Polygon body(int) const {
    static constexpr krait::Vec2 corners[] = {{-0.3F, -0.3F}, {0.3F, -0.3F}, {0.3F, 0.3F}, {-0.3F, 0.3F}};
    return {corners, 4};
  }
  void place(krait::StateView s, krait::Pose* poses) const { poses[0] = {krait::position(s), {0.0F, 1.0F}}; }
  bool travel(krait::StateView s, krait::ControlView u, float dt, krait::StateView, krait::Travel* travel) const {
    const float faster = dt * u.norm();  // the speed changes by
    travel[0] = {.path = dt * (s.tail(2).norm() + faster), .turn = 0, .bend = dt * faster / 8, .twist = 0};
    return true;  // within_limits holds all the way: it does at both ends, and the velocity goes straight
  }
};
