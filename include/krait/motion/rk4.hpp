// MOTION (Eqn 2): fourth-order Runge-Kutta over one time step with the control held.
#pragma once

#include "krait/robot/robot.hpp"

namespace krait {

// What a robot says of its dynamics during a step from `state`, whose frames are `poses`; itself where it says nothing.
template <Robot R>
class Dynamics {
 public:
  Dynamics(const R& robot, StateView state, ControlView u) : robot_(&robot), state_(state), control_(u) {}
  void derivative(StateRef ds) const { robot_->derivative(state_, control_, ds); }
  void derivative(StateView s, StateRef ds) const { robot_->derivative(s, control_, ds); }

 private:
  const R* robot_;
  StateView state_;
  ControlView control_;
};

template <Robot R>
auto dynamics_near(const R& robot, StateView state, const Pose* poses, ControlView u, float dt) {
  if constexpr (requires { robot.near(state, poses, u, dt); }) {
    return robot.near(state, poses, u, dt);
  } else {
    return Dynamics<R>(robot, state, u);
  }
}

// What dt seconds add to a state, whose bodies' frames are `poses`, or to its leading components: calls
// add(i, increment) for every one. Four derivatives.
template <Robot R, class Add>
void runge_kutta(const R& robot, StateView state, const Pose* poses, const float* control, float dt, Add add) {
  const int n = static_cast<int>(state.size());
  float k1[R::kMaxState];
  float k23[R::kMaxState];
  float k[R::kMaxState];
  float middle[R::kMaxState];
  const auto dynamics = dynamics_near(robot, state, poses, ControlView(control, robot.control_size()), dt);
  const float half = 0.5F * dt;
  dynamics.derivative(StateRef(k1, n));
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k1[i];
  const StateView at(middle, n);
  dynamics.derivative(at, StateRef(k23, n));
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k23[i];
  dynamics.derivative(at, StateRef(k, n));
  for (int i = 0; i < n; ++i) {
    middle[i] = state[i] + dt * k[i];
    k23[i] = k23[i] + k[i];
  }
  dynamics.derivative(at, StateRef(k, n));
  const float sixth = dt / 6.0F;
  for (int i = 0; i < n; ++i) add(i, sixth * ((k1[i] + k[i]) + 2.0F * k23[i]));
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
