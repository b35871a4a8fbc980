// MOTION (Eqn 2): fourth-order Runge-Kutta over one time step with the control held.
#pragma once

#include "krait/robot/robot.hpp"

namespace krait {

// What dt seconds add to a state, or to its leading components: d, as many floats. Four derivatives.
template <Robot R>
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

// A step of dt seconds, whose leading components may be known before the rest.
template <Robot R>
class Motion {
 public:
  // What the step adds to a state, whose bodies' frames are `poses`, or to its leading components: writes to d those of
  // a robot that integrates them first, else all.
  void integrate_lead(const R& robot, StateView state, const Pose* poses, const float* control, float dt, float* d) {
    const ControlView u(control, robot.control_size());
    if constexpr (LeadingRobot<R>) {
      robot.integrate_lead(state, poses, u, dt, lead_, d);
    } else {
      runge_kutta(robot, state, u, dt, d);
    }
  }

  // Where the step leads, as far as integrate_lead tells; `next` may not overlap `state`.
  void lead(const R& robot, const float* state, const Pose* poses, const float* control, float dt, float* next) {
    integrate_lead(robot, StateView(state, robot.state_size()), poses, control, dt, next);
    for (int i = 0; i < first_of_rest(robot); ++i) next[i] = state[i] + next[i];
  }

  // The rest of it, by the same arguments.
  void follow(const R& robot, const float* state, const Pose* poses, float dt, float* next) const {
    if constexpr (LeadingRobot<R>) {
      robot.integrate_rest(StateView(state, robot.state_size()), poses, dt, lead_, next);
      for (int i = first_of_rest(robot); i < robot.state_size(); ++i) next[i] = state[i] + next[i];
    }
  }

 private:
  static int first_of_rest(const R& robot) {
    if constexpr (LeadingRobot<R>) return robot.leading_size();
    return robot.state_size();
  }

  LeadOf<R> lead_;
};

// next = the state after dt seconds; `next` may not overlap `state`, whose frames are `poses`.
template <Robot R>
void propagate(const R& robot, const float* state, const Pose* poses, const float* control, float dt, float* next) {
  Motion<R> motion;
  motion.lead(robot, state, poses, control, dt, next);
  motion.follow(robot, state, poses, dt, next);
}

// The same where the frames have yet to be found.
template <Robot R>
void propagate(const R& robot, const float* state, const float* control, float dt, float* next) {
  Pose poses[R::kMaxBodies];
  robot.place(StateView(state, robot.state_size()), poses);
  propagate(robot, state, poses, control, dt, next);
}

}  // namespace krait
