// MOTION (Eqn 2): fourth-order Runge-Kutta over one time step with the control held.
#pragma once

#include "krait/robot/robot.hpp"

namespace krait {

// What dt seconds add to a state by the rates there and at three states that they lead to: d, as many floats as the
// state has, of which kSize is no less. rates_here(ds) gives those at the state, rates_at(s, ds) those at another.
template <int kSize, class RatesHere, class RatesAt>
void integrate_by_stages(StateView state, float dt, RatesHere rates_here, RatesAt rates_at, float* d) {
  const int n = static_cast<int>(state.size());
  float k1[kSize];
  float k23[kSize];
  float k[kSize];
  float middle[kSize] = {};  // for compilers that doubt that n is above 0
  const float half = 0.5F * dt;
  rates_here(StateRef(k1, n));
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k1[i];
  const StateView at(middle, n);
  rates_at(at, StateRef(k23, n));
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k23[i];
  rates_at(at, StateRef(k, n));
  for (int i = 0; i < n; ++i) {
    middle[i] = state[i] + dt * k[i];
    k23[i] = k23[i] + k[i];
  }
  rates_at(at, StateRef(k, n));
  const float sixth = dt / 6.0F;
  for (int i = 0; i < n; ++i) d[i] = sixth * ((k1[i] + k[i]) + 2.0F * k23[i]);
}

// What dt seconds add to a state, whose bodies' frames are `poses`, or to its leading components: calls
// add(i, increment) for every one. Four derivatives.
template <Robot R, class Add>
void runge_kutta(const R& robot, StateView state, const Pose* poses, const float* control, float dt, Add add) {
  const ControlView u(control, robot.control_size());
  float d[R::kMaxState];
  if constexpr (requires { robot.integrate(state, poses, u, dt, d); }) {
    robot.integrate(state, poses, u, dt, d);
  } else {
    const auto rates = [&](StateView s, StateRef ds) { robot.derivative(s, u, ds); };
    integrate_by_stages<R::kMaxState>(
        state, dt, [&](StateRef ds) { rates(state, ds); }, rates, d);
  }
  const int n = static_cast<int>(state.size());
  for (int i = 0; i < n; ++i) add(i, d[i]);
}

// next = the state after dt seconds; `next` may not overlap `state`.
template <Robot R>
void propagate(const R& robot, const float* state, const Pose* poses, const float* control, float dt, float* next) {
  runge_kutta(robot, StateView(state, robot.state_size()), poses, control, dt,
              [state, next](int i, float increment) { next[i] = state[i] + increment; });
}

// The same where the frames have yet to be found.
template <Robot R>
void propagate(const R& robot, const float* state, const float* control, float dt, float* next) {
  Pose poses[R::kMaxBodies];
  robot.place(StateView(state, robot.state_size()), poses);
  propagate(robot, state, poses, control, dt, next);
}

}  // namespace krait
