// SPDX-License-Identifier: Apache-2.0
// CONTROLLER and MOTION (Algorithm 2, lines 5 and 6): from a state toward a target, step by step.
#pragma once

#include "motion/rk4.hpp"

namespace krait::detail {

// Determined by the state where it begins, the target and the number of steps: driven again, it has the same bits.
class Drive {
 public:
  // The robot must outlive this; time steps last dt seconds.
  void assign(const Robot& robot, float dt);

  // Starts from a state, which is copied.
  void begin(const float* state);

  // Steers toward a target from here on, with a fresh controller.
  void aim(const Target& target);

  // Finds the control at state(), whose bodies' frames are `poses`, and where it leads as far as Motion::lead computes
  // it.
  void lead(const Pose* poses);

  // The rest of where it leads.
  void follow(const Pose* poses);

  // Goes there.
  void go() { here_ = 1 - here_; }

  // All of a step, which nothing proves.
  void step();

  const float* state() const { return states_[here_]; }
  const float* control() const { return control_; }         // of the last step
  const float* next() const { return states_[1 - here_]; }  // where it leads, until go
  const Target& target() const { return target_; }

 private:
  Robot robot_;
  float dt_ = 0.1F;
  int parts_ = 1;  // Runge-Kutta steps of a time step
  int here_ = 0;
  float states_[2][kMaxState];
  float control_[kMaxControl];
  Target target_;
  Steering steering_;
  Motion motion_;
};

}  // namespace krait::detail
