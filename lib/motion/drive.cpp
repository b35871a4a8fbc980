// SPDX-License-Identifier: Apache-2.0
#include "motion/drive.hpp"

namespace krait::detail {

void Drive::assign(const Robot& robot, float dt) {
  robot_ = robot;
  dt_ = dt;
  parts_ = parts_of(dt, longest_tree_step(robot, dt), kMostParts);
}

void Drive::begin(const float* state) {
  for (int i = 0; i < robot_.state_size(); ++i) states_[here_][i] = state[i];
}

void Drive::aim(const Target& target) {
  target_ = target;
  target_.dt = dt_;
  steering_ = {};
}

void Drive::lead(const Pose* poses) {
  const float* const state = states_[here_];
  float* const next = states_[1 - here_];
  robot_.steer(state, poses, target_, steering_, control_);
  if (parts_ == 1) {
    motion_.lead(robot_, state, poses, control_, dt_, next);
  } else {
    propagate_in_parts(robot_, state, poses, control_, dt_, parts_, next);
  }
}

void Drive::follow(const Pose* poses) {
  if (parts_ == 1) motion_.follow(robot_, states_[here_], poses, dt_, states_[1 - here_]);
}

void Drive::step() {
  Pose poses[kMaxBodies];
  robot_.place(state(), poses);
  lead(poses);
  follow(poses);
  go();
}

}  // namespace krait::detail
