// MOTION (Eqn 2): fourth-order Runge-Kutta over one time step with the control held.
#pragma once

#include "krait/robot/robot.hpp"

namespace krait {

// next = the state after dt seconds; `next` may not overlap `state`. Four derivatives.
template <Robot R>
void propagate(const R& robot, const float* state, const float* control, float dt, float* next) {
  const int n = robot.state_size();
  float k1[R::kMaxState];
  float k2[R::kMaxState];
  float k3[R::kMaxState];
  float k4[R::kMaxState];
  float middle[R::kMaxState] = {};
  const ControlView u(control, robot.control_size());
  const auto rate = [&](const float* s, float* ds) { robot.derivative(StateView(s, n), u, StateRef(ds, n)); };
  const float half = 0.5F * dt;
  rate(state, k1);
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k1[i];
  rate(middle, k2);
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k2[i];
  rate(middle, k3);
  for (int i = 0; i < n; ++i) middle[i] = state[i] + dt * k3[i];
  rate(middle, k4);
  const float sixth = dt / 6.0F;
  for (int i = 0; i < n; ++i) next[i] = state[i] + sixth * ((k1[i] + k4[i]) + 2.0F * (k2[i] + k3[i]));
}

}  // namespace krait
