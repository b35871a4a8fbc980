// SPDX-License-Identifier: Apache-2.0
// CONTROLLER and MOTION (Algorithm 2, lines 5 and 6): from a state toward a target, step by step.
#pragma once

#include "krait/motion/rk4.hpp"

namespace krait {

// Determined by the state where it begins, the target and the number of steps: driven again, it has the same bits.
template <Robot R>
class Drive {
 public:
  // The robot must outlive this; time steps last dt seconds.
  void assign(const R& robot, float dt) {
    robot_ = &robot;
    dt_ = dt;
    parts_ = parts_of(dt, longest_tree_step(robot, dt), kMostParts);
  }
  void assign(const R&&, float) = delete;

  // Where to start; copied.
  void begin(const float* state) {
    for (int i = 0; i < robot_->state_size(); ++i) states_[here_][i] = state[i];
  }

  // Where to go from here, with a fresh controller.
  void aim(const Target& target) {
    target_ = target;
    target_.dt = dt_;
    steering_ = {};
  }

  // Finds the control at state(), whose bodies' frames are `poses`, and where it leads as far as Motion::lead tells.
  void lead(const Pose* poses) {
    const float* const state = states_[here_];
    float* const next = states_[1 - here_];
    const StateView view(state, robot_->state_size());
    steer(*robot_, view, poses, target_, steering_, ControlRef(control_, robot_->control_size()));
    if (parts_ == 1) {
      motion_.lead(*robot_, state, poses, control_, dt_, next);
    } else {
      propagate_in_parts(*robot_, state, poses, control_, dt_, parts_, next);
    }
  }

  // The rest of where it leads.
  void follow(const Pose* poses) {
    if (parts_ == 1) motion_.follow(*robot_, states_[here_], poses, dt_, states_[1 - here_]);
  }

  // Goes there.
  void go() { here_ = 1 - here_; }

  const float* state() const { return states_[here_]; }
  const float* control() const { return control_; }         // of the last step
  const float* next() const { return states_[1 - here_]; }  // where it leads, until go
  const Target& target() const { return target_; }

 private:
  const R* robot_ = nullptr;
  float dt_ = 0.1F;
  int parts_ = 1;  // Runge-Kutta steps of a time step
  int here_ = 0;
  float states_[2][R::kMaxState];
  float control_[R::kMaxControl];
  Target target_;
  Steering steering_;
  Motion<R> motion_;
};

}  // namespace krait
