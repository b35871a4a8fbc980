// SPDX-License-Identifier: Apache-2.0
// A fourth-order Runge-Kutta step of Eqn 2 with the control held, by a model's derivative.
#pragma once

#include "krait/robot/robot_model.hpp"

namespace krait {

// What dt seconds add to a state, or to its leading components: d, as many floats. Four derivatives.
template <RobotModel R>
void runge_kutta(const R& robot, StateView state, ControlView u, float dt, float* d) {
  const int n = static_cast<int>(state.size());
  float k1[R::kMaxState];
  float k23[R::kMaxState];
  float k[R::kMaxState];
  float middle[R::kMaxState] = {};  // for compilers that doubt that n is above 0
  const float half = 0.5F * dt;
  robot.derivative(state, u, StateRef(k1, n));
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k1[i];
  const StateView at(middle, n);
  robot.derivative(at, u, StateRef(k23, n));
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k23[i];
  robot.derivative(at, u, StateRef(k, n));
  for (int i = 0; i < n; ++i) {
    middle[i] = state[i] + dt * k[i];
    k23[i] = k23[i] + k[i];
  }
  robot.derivative(at, u, StateRef(k, n));
  const float sixth = dt / 6.0F;
  for (int i = 0; i < n; ++i) d[i] = sixth * ((k1[i] + k[i]) + 2.0F * k23[i]);
}

}  // namespace krait
