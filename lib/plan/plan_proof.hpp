// SPDX-License-Identifier: Apache-2.0
// A way to the goal is driven once more from the start as the plan's controls alone would drive the robot, and every
// step is proven again: what holds is the plan.
#pragma once

#include "motion/plan_drive.hpp"
#include "plan/plan_meter.hpp"
#include "plan/proven_step.hpp"
#include "robot/shape.hpp"

namespace krait::detail {

// How deep inside the goal a plan ends, metres: by what its states may be off by, but within these.
struct EndDepth {
  float least = 0.0F;
  float most = 0.0F;
};

class PlanProof {
 public:
  // All arguments but the start must outlive this. The start is state_size() floats, copied. Before the first step:
  // place().
  void begin(const Robot& robot, const Scene& scene, const Parameters& parameters, MotionCheck& check,
             const float* start);

  // Places the robot at the start.
  void place();

  // The next steps are toward this target, with a fresh controller.
  void aim(const Target& target) { drive_.aim(target); }

  // Makes the check keep the margin that the way so far requires. O(bodies).
  void keep();

  // Drives a step. False when it is not proven, or when the states would be too far from where the controls lead.
  bool step();

  // How deep inside the goal the plan that ends here must do so.
  float end_depth(const EndDepth& depth) const;

  const float* state() const { return drive_.state(); }
  // The tree's state beside it.
  const float* tree_state() const { return drive_.tree_state(); }
  // The measures of the plan that ends here.
  PlanMeasures measures() { return meter_.end(drive_.state(), robot_.state_size()); }

 private:
  // How far driven states may be from where the controls lead: lib/DESIGN.md, "Integration".
  static constexpr float kDriveError = 1e-4F;  // metres: the least error that the check allows for
  static constexpr float kDriftShare = 5e-6F;  // share of the way of body 0's ends that is added to the error
  static constexpr float kMostError = 2e-3F;   // the largest error of a component, in its unit, where that is near 0
  static constexpr float kLarge = 256.0F;  // a component, in its unit: of so large a one the error may be twice that
  static constexpr float kSpare = 2.0F;    // times the errors that grew: what the check then allows for

  // Metres: how far the states so far may be from where the controls lead.
  float error() const { return allowed_ + kDriftShare * (meter_.length() + turned_ * robot_length(robot_)); }

  // Carries the errors on over the step that drive_ found, and has the check keep more where they outgrow what it
  // keeps. False where one is too large.
  bool carry_errors_on();

  Robot robot_;
  const Parameters* parameters_ = nullptr;
  MotionCheck* check_ = nullptr;
  ProvenStep step_;
  PlanDrive drive_;
  PlanMeter meter_;
  float turned_ = 0.0F;          // radians, of body 0 so far, as chords
  float strayed_ = 0.0F;         // metres: how far a body may be from where the controls lead, by errors that grew
  float allowed_ = kDriveError;  // metres: how far the check allows for
  float errors_[kMaxState];      // of the state's components
};

}  // namespace krait::detail
