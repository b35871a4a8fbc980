// SPDX-License-Identifier: Apache-2.0
#include "plan/plan_walk.hpp"

namespace krait::detail {

PlanWalk::PlanWalk(const Robot& robot, const PlanPath& path, const float* start, float dt)
    : robot_(robot), path_(path), leg_(path.first()) {
  drive_.begin(robot, dt, start);
  enter();
}

void PlanWalk::advance() {
  KRAIT_ASSERT(!done());
  drive_.go();
  if (++step_ == path_.steps(leg_)) {
    leg_ = path_.next(leg_);
    enter();
  } else {
    step();
  }
}

void PlanWalk::enter() {
  step_ = 0;
  if (leg_ == kNone) return;
  drive_.aim(path_.target(leg_));
  step();
}

void PlanWalk::step() {
  Pose poses[kMaxBodies];
  robot_.place(drive_.state(), poses);
  drive_.step(poses);
}

}  // namespace krait::detail
