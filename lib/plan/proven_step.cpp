// SPDX-License-Identifier: Apache-2.0
#include "plan/proven_step.hpp"

namespace krait::detail {

bool ProvenStep::prove(Drive& drive) {
  drive.lead(check_->poses());
  const float* const state = drive.state();
  const float* const next = drive.next();
  if (!check_->lead_free(state, next)) return false;
  drive.follow(check_->poses());
  if (!robot_.keeps_reserve(next)) return false;
  return free(state, drive.control(), next);
}

bool ProvenStep::holds(const float* state, const float* control, const float* next) {
  return robot_.within_limits(next) && free(state, control, next);
}

bool ProvenStep::free(const float* state, const float* control, const float* next) {
  if (!scene_->inside_bounds({next[0], next[1]})) return false;
  const float dt = parameters_->dt;
  if (parameters_->tuning.continuous) return check_->step_free(state, control, dt, next);
  return check_->keeps_limits(state, control, dt, next) && check_->free(next);
}

}  // namespace krait::detail
