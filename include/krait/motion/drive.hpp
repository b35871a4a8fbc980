// CONTROLLER and MOTION (Algorithm 2, lines 5 and 6): from a state toward a target, step by step.
#pragma once

#include "krait/motion/rk4.hpp"

namespace krait {

// Fully told by the state it begins from, the target and the number of steps: driven again, it gives the same bits.
template <Robot R>
class Drive {
 public:
  // Where to start; copied. The robot must outlive this.
  void begin(const R& robot, const float* state) {
    robot_ = &robot;
    for (int i = 0; i < robot.state_size(); ++i) states_[here_][i] = state[i];
  }

  // Where to go from here, the controller as new.
  void aim(const Target& target) {
    target_ = target;
    steering_ = {};
  }

  // Finds the control at state(), whose bodies' frames are `poses`, and where it leads as far as Motion::lead tells.
  void lead(const Pose* poses) {
    const StateView state(states_[here_], robot_->state_size());
    steer(*robot_, state, poses, target_, steering_, ControlRef(control_, robot_->control_size()));
    motion_.lead(*robot_, states_[here_], poses, control_, target_.dt, states_[1 - here_]);
  }

  // The rest of where it leads.
  void follow(const Pose* poses) { motion_.follow(*robot_, states_[here_], poses, target_.dt, states_[1 - here_]); }

  // Goes there.
  void go() { here_ = 1 - here_; }

  const float* state() const { return states_[here_]; }
  const float* control() const { return control_; }         // of the last step
  const float* next() const { return states_[1 - here_]; }  // where it leads, until go
  const Target& target() const { return target_; }

 private:
  const R* robot_ = nullptr;
  int here_ = 0;
  float states_[2][R::kMaxState];
  float control_[R::kMaxControl];
  Target target_;
  Steering steering_;
  Motion<R> motion_;
};

}  // namespace krait
