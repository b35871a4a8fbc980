// SPDX-License-Identifier: Apache-2.0
// MOTION (Eqn 2): fourth-order Runge-Kutta with the control held. A time step is divided into as many equal
// Runge-Kutta steps as keep the local error bounded (lib/DESIGN.md, "Integration").
#pragma once

#include <cstdint>

#include "krait/robot/robot.hpp"

namespace krait {

// A Runge-Kutta step of h seconds is accurate enough where h times the robot's fastest rate is at most this: while the
// tree grows; where a plan with trailers is driven, which follow and forget; and where errors stay or grow.
inline constexpr float kStepRate = 0.32F;
inline constexpr float kPlanStepRate = 0.16F;
inline constexpr float kFinePlanStepRate = 0.05F;

// The most Runge-Kutta steps of a time step: while the tree grows, init refuses what would need more; in a plan.
inline constexpr int kMostParts = 16;
inline constexpr int kMostPlanParts = 103;

// How many equal parts of `whole`, which is positive, are at most `longest` each; 1 or more, `most` at most.
inline int parts_of(float whole, float longest, int most) {
  int parts = 1;
  while (parts < most && static_cast<float>(parts) * longest < whole) ++parts;
  return parts;
}

// The longest Runge-Kutta step in seconds of time steps of dt, infinite for a robot that does not state its rate.
template <Robot R>
float longest_step(const R& robot, float dt, float step_rate) {
  const float rate = fastest_rate(robot, dt);
  return rate > 0.0F ? step_rate / rate : kInfinity;
}
template <Robot R>
float longest_tree_step(const R& robot, float dt) {
  return longest_step(robot, dt, kStepRate);
}
template <Robot R>
float longest_plan_step(const R& robot, float dt) {
  const bool follows = leading_size(robot) < robot.state_size() && !reversible(robot);
  return longest_step(robot, dt, follows ? kPlanStepRate : kFinePlanStepRate);
}

// Whether time steps of dt seconds need at most kMostParts.
template <Robot R>
bool can_integrate(const R& robot, float dt) {
  return dt <= static_cast<float>(kMostParts) * longest_tree_step(robot, dt);
}

// The longest time step of at least 0.001 s and at most dt that needs at most kMostParts; 0 where there is none. At
// most 24 evaluations of the robot's fastest rate.
template <Robot R>
float longest_time_step(const R& robot, float dt) {
  float fits = 0.001F;
  if (!can_integrate(robot, fits)) return 0.0F;
  float too_long = dt;
  for (int halving = 0; halving < 24; ++halving) {
    const float middle = 0.5F * (fits + too_long);
    (can_integrate(robot, middle) ? fits : too_long) = middle;
  }
  return fits;
}

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

// A Runge-Kutta step of dt seconds, whose leading components may be known before the rest.
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

  // The rest of what it adds, by the same arguments.
  void integrate_rest(const R& robot, StateView state, const Pose* poses, float dt, float* d) const {
    if constexpr (LeadingRobot<R>) robot.integrate_rest(state, poses, dt, lead_, d);
  }

  // Where the step leads, as far as integrate_lead tells; `next` may not overlap `state`.
  void lead(const R& robot, const float* state, const Pose* poses, const float* control, float dt, float* next) {
    integrate_lead(robot, StateView(state, robot.state_size()), poses, control, dt, next);
    for (int i = 0; i < first_of_rest(robot); ++i) next[i] = state[i] + next[i];
  }

  // The rest of it, by the same arguments.
  void follow(const R& robot, const float* state, const Pose* poses, float dt, float* next) const {
    integrate_rest(robot, StateView(state, robot.state_size()), poses, dt, next);
    for (int i = first_of_rest(robot); i < robot.state_size(); ++i) next[i] = state[i] + next[i];
  }

 private:
  static int first_of_rest(const R& robot) {
    if constexpr (LeadingRobot<R>) return robot.leading_size();
    return robot.state_size();
  }

  LeadOf<R> lead_;
};

// next = the state after one Runge-Kutta step of dt seconds; `next` may not overlap `state`, whose frames are `poses`.
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

// next = the state after dt seconds in `parts` >= 1 equal Runge-Kutta steps; the rest as propagate.
template <Robot R>
[[gnu::noinline]] void propagate_in_parts(const R& robot, const float* state, const Pose* poses, const float* control,
                                          float dt, int parts, float* next) {
  const int size = robot.state_size();
  const float part = dt / static_cast<float>(parts);
  propagate(robot, state, poses, control, part, next);
  float from[R::kMaxState];
  for (int done = 1; done < parts; ++done) {
    for (int i = 0; i < size; ++i) from[i] = next[i];
    propagate(robot, from, control, part, next);
  }
}

}  // namespace krait
