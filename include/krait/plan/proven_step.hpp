// SPDX-License-Identifier: Apache-2.0
// COLLISION (Algorithm 2, line 6) of a step of a drive: what the tree, a plan and a better way must hold to alike.
#pragma once

#include "krait/collision/motion_check.hpp"
#include "krait/motion/drive.hpp"
#include "krait/parameters.hpp"

namespace krait {

// Robot, scene, parameters and check must outlive this. The check's next step begins from the step's state.
template <Robot R>
class ProvenStep {
 public:
  ProvenStep() = default;
  ProvenStep(const R& robot, const Scene& scene, const Parameters& parameters, MotionCheck<R>& check)
      : robot_(&robot), scene_(&scene), parameters_(&parameters), check_(&check) {}

  // Finds the drive's next step. False when it is not free or leaves the robot's limits or their reserve.
  bool take(Drive<R>& drive) {
    drive.lead(check_->poses());
    const float* const state = drive.state();
    const float* const next = drive.next();
    if (!check_->lead_free(state, next)) return false;
    drive.follow(check_->poses());
    if (!keeps_reserve(*robot_, StateView(next, robot_->state_size()))) return false;
    return holds(state, drive.control(), next);
  }

  // Whether a step is free and within the limits and the bounds.
  bool holds(const float* state, const float* control, const float* next) {
    if (!robot_->within_limits(StateView(next, robot_->state_size()))) return false;
    if (!scene_->inside_bounds({next[0], next[1]})) return false;
    const float dt = parameters_->dt;
    if (parameters_->continuous) return check_->step_free(state, control, dt, next);
    return check_->keeps_limits(state, control, dt, next) && check_->free(next);
  }

 private:
  const R* robot_ = nullptr;
  const Scene* scene_ = nullptr;
  const Parameters* parameters_ = nullptr;
  MotionCheck<R>* check_ = nullptr;
};

}  // namespace krait
