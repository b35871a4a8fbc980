// MOTION (Eqn 2): fourth-order Runge-Kutta over one time step with the control held.
#pragma once

#include "krait/robot/robot.hpp"

namespace krait {

// What a robot says of its dynamics near `state`, whose frames are `poses`; itself where it says nothing.
template <Robot R>
class Dynamics {
 public:
  Dynamics(const R& robot, StateView state, const Pose*) : robot_(&robot), state_(state) {}
  void derivative(ControlView u, StateRef ds) const { robot_->derivative(state_, u, ds); }
  void derivative(StateView s, ControlView u, StateRef ds) const { robot_->derivative(s, u, ds); }

 private:
  const R* robot_;
  StateView state_;
};

template <Robot R>
auto dynamics_near(const R& robot, StateView state, const Pose* poses) {
  if constexpr (requires { robot.near(state, poses); }) {
    return robot.near(state, poses);
  } else {
    return Dynamics<R>(robot, state, poses);
  }
}

// next = the state after dt seconds; `next` may not overlap `state`, whose bodies' frames are `poses`. Four
// derivatives.
template <Robot R>
void propagate(const R& robot, const float* state, const Pose* poses, const float* control, float dt, float* next) {
  const int n = robot.state_size();
  float k1[R::kMaxState];
  float k23[R::kMaxState];
  float k[R::kMaxState];
  float middle[R::kMaxState];
  const StateView s(state, n);
  const StateView at(middle, n);
  const ControlView u(control, robot.control_size());
  const auto dynamics = dynamics_near(robot, s, poses);
  const float half = 0.5F * dt;
  dynamics.derivative(u, StateRef(k1, n));
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k1[i];
  dynamics.derivative(at, u, StateRef(k23, n));
  for (int i = 0; i < n; ++i) middle[i] = state[i] + half * k23[i];
  dynamics.derivative(at, u, StateRef(k, n));
  for (int i = 0; i < n; ++i) {
    middle[i] = state[i] + dt * k[i];
    k23[i] = k23[i] + k[i];
  }
  dynamics.derivative(at, u, StateRef(k, n));
  const float sixth = dt / 6.0F;
  for (int i = 0; i < n; ++i) next[i] = state[i] + sixth * ((k1[i] + k[i]) + 2.0F * k23[i]);
}

// The same where the frames have yet to be found.
template <Robot R>
void propagate(const R& robot, const float* state, const float* control, float dt, float* next) {
  Pose poses[R::kMaxBodies];
  robot.place(StateView(state, robot.state_size()), poses);
  propagate(robot, state, poses, control, dt, next);
}

}  // namespace krait
