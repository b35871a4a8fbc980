// SPDX-License-Identifier: Apache-2.0
// Drives a plan again, step by step: its states are those of PlanDrive.
#pragma once

#include "krait/plan.hpp"
#include "krait/status.hpp"
#include "motion/plan_drive.hpp"

namespace krait::detail {

// The implementation of PlanCursor, which holds one.
class PlanWalk {
 public:
  PlanWalk() = default;
  PlanWalk(const Robot& robot, const PlanPath& path, const float* start, float dt);

  int state_size() const { return robot_.state_size(); }
  int control_size() const { return robot_.control_size(); }

  // Whether this is the last state.
  bool done() const { return leg_ == kNone; }
  // state_size() floats.
  const float* state() const { return drive_.state(); }
  // control_size() floats, held for dt from this state on; not when done.
  const float* control() const {
    KRAIT_ASSERT(!done());
    return drive_.control();
  }
  // The state that the control leads to; not when done.
  const float* next() const {
    KRAIT_ASSERT(!done());
    return drive_.next();
  }

  // Goes on to the next state; must not be called when done. Work: one control and the Runge-Kutta steps of a time
  // step.
  void advance();

 private:
  void enter();

  void step();

  Robot robot_;
  PlanPath path_;
  Index leg_ = kNone;
  std::uint32_t step_ = 0;
  PlanDrive drive_;
};

}  // namespace krait::detail
