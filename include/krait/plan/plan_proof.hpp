// SPDX-License-Identifier: Apache-2.0
// A way to the goal is driven once more from the start as the plan's controls alone would drive the robot, and every
// step is proven again: what holds is the plan.
#pragma once

#include "krait/plan/plan.hpp"
#include "krait/plan/proven_step.hpp"
#include "krait/robot/shape.hpp"

namespace krait {

template <Robot R>
class PlanProof {
 public:
  // Whatever is given must outlive this. The start is state_size() floats, copied. Before the first step: place().
  void begin(const R& robot, const Scene& scene, const Parameters& parameters, MotionCheck<R>& check,
             const float* start) {
    robot_ = &robot;
    parameters_ = &parameters;
    check_ = &check;
    step_ = ProvenStep<R>(robot, scene, parameters, check);
    meter_ = {};
    turned_ = 0.0F;
    drive_.begin(robot, parameters.dt, start);
  }

  // Places the robot at the start.
  void place() {
    keep();
    check_->begin(drive_.state());
  }

  // The next steps are toward this target, with a fresh controller.
  void aim(const Target& target) { drive_.aim(target); }

  // From now on the check keeps the margin that the way so far asks for. O(bodies).
  void keep() {
    const float error = kDriveError + kDriftShare * (meter_.length() + turned_ * robot_length(*robot_));
    check_->keep(parameters_->clearance + error, longest_plan_step(*robot_, parameters_->dt));
  }

  // Drives a step. False when it is not proven.
  bool step() {
    const SinCos heading = check_->poses()[0].heading;
    drive_.step(check_->poses());
    if (!step_.holds(drive_.state(), drive_.control(), drive_.next())) return false;
    meter_.add(drive_.state(), robot_->state_size(), drive_.control(), robot_->control_size(), drive_.next());
    drive_.go();
    const SinCos after = check_->poses()[0].heading;
    turned_ += length(Vec2{after.cos - heading.cos, after.sin - heading.sin});
    return true;
  }

  const float* state() const { return drive_.state(); }
  // The tree's state beside it.
  const float* tree_state() const { return drive_.tree_state(); }
  // Of the plan that ends here.
  PlanMeasures measures() { return meter_.end(drive_.state(), robot_->state_size()); }

 private:
  static constexpr float kDriveError = 1e-4F;  // metres: how far the driven states may be off, and
  static constexpr float kDriftShare = 5e-6F;  // by how much of the way of body 0's ends more

  const R* robot_ = nullptr;
  const Parameters* parameters_ = nullptr;
  MotionCheck<R>* check_ = nullptr;
  ProvenStep<R> step_;
  PlanDrive<R> drive_;
  PlanMeter meter_;
  float turned_ = 0.0F;  // radians, of body 0 so far, as chords
};

}  // namespace krait
