// SPDX-License-Identifier: Apache-2.0
// COLLISION (Algorithm 2, line 6) of a step of a drive: what the tree, a plan and a better way must hold to alike.
#pragma once

#include "collision/motion_check.hpp"
#include "krait/parameters.hpp"
#include "motion/drive.hpp"

namespace krait::detail {

// Robot, scene, parameters and check must outlive this. The check's next step begins from the step's state.
class ProvenStep {
 public:
  ProvenStep() = default;
  ProvenStep(const Robot& robot, const Scene& scene, const Parameters& parameters, MotionCheck& check)
      : robot_(robot), scene_(&scene), parameters_(&parameters), check_(&check) {}

  // Finds the drive's next step. False when it is not free or leaves the robot's limits or their reserve.
  bool prove(Drive& drive);

  // Whether a step is free and within the limits and the bounds.
  bool holds(const float* state, const float* control, const float* next);

 private:
  // Whether a step whose ends are within the limits is free, and within them all the way and the bounds.
  bool free(const float* state, const float* control, const float* next);

  Robot robot_;
  const Scene* scene_ = nullptr;
  const Parameters* parameters_ = nullptr;
  MotionCheck* check_ = nullptr;
};

}  // namespace krait::detail
