// SPDX-License-Identifier: Apache-2.0
#include "plan/plan_proof.hpp"

#include <algorithm>

namespace krait::detail {

void PlanProof::begin(const Robot& robot, const Scene& scene, const Parameters& parameters, MotionCheck& check,
                      const float* start) {
  robot_ = robot;
  parameters_ = &parameters;
  check_ = &check;
  step_ = ProvenStep(robot, scene, parameters, check);
  meter_ = {};
  turned_ = 0.0F;
  strayed_ = 0.0F;
  for (int i = 0; i < robot.state_size(); ++i) errors_[i] = 0.0F;
  drive_.begin(robot, parameters.dt, start);
}

void PlanProof::place() {
  keep();
  check_->begin(drive_.state());
}

void PlanProof::keep() {
  allowed_ = std::max(kDriveError, kSpare * strayed_);
  check_->keep(parameters_->clearance + error(), longest_plan_step(robot_, parameters_->dt));
}

bool PlanProof::step() {
  const SinCos heading = check_->poses()[0].heading;
  drive_.step(check_->poses());
  if (!carry_errors_on()) return false;
  if (!step_.holds(drive_.state(), drive_.control(), drive_.next())) return false;
  meter_.add(drive_.state(), robot_.state_size(), drive_.control(), robot_.control_size(), drive_.next());
  drive_.go();
  const SinCos after = check_->poses()[0].heading;
  turned_ += length(Vec2{after.cos - heading.cos, after.sin - heading.sin});
  return true;
}

float PlanProof::end_depth(const EndDepth& depth) const {
  const float off = std::min(depth.most, error());
  return std::max(depth.least, off);
}

bool PlanProof::carry_errors_on() {
  const int size = robot_.state_size();
  const float* const next = drive_.next();
  strayed_ = robot_.carry_errors(drive_.state(), check_->poses(), drive_.control(), parameters_->dt, errors_);
  for (int i = 0; i < size; ++i) {
    if (!(math::absolute(errors_[i]) <= kMostError * (1.0F + math::absolute(next[i]) / kLarge))) return false;
  }
  if (strayed_ > allowed_) place();
  return finite(strayed_);
}

}  // namespace krait::detail
