// SPDX-License-Identifier: Apache-2.0
#include "motion/plan_drive.hpp"

namespace krait::detail {

void PlanDrive::begin(const Robot& robot, float dt, const float* state) {
  robot_ = robot;
  dt_ = dt;
  tree_.assign(robot, dt);
  tree_.begin(state);
  const float longest = longest_plan_step(robot, dt);
  parts_ = longest < kInfinity ? parts_of(dt, longest, kMostPlanParts) : kUnknownParts;
  for (int i = 0; i < robot.state_size(); ++i) {
    states_[here_][i] = state[i];
    rests_[here_][i] = 0.0F;
  }
}

void PlanDrive::step(const Pose* poses) {
  const int size = robot_.state_size();
  float* const next = states_[1 - here_];
  Pose own[kMaxBodies];
  follow_tree(own);
  for (int i = 0; i < size; ++i) {
    next[i] = state()[i];
    rests_[1 - here_][i] = rests_[here_][i];
  }
  const float part = dt_ / static_cast<float>(parts_);
  integrate(poses, part);
  for (int done = 1; done < parts_; ++done) {
    robot_.place(next, own);
    integrate(own, part);
  }
  refine();
}

void PlanDrive::go() {
  here_ = 1 - here_;
  tree_.go();
}

void PlanDrive::follow_tree(Pose* poses) {
  const float* const reference = tree_.state();
  robot_.place(reference, poses);
  tree_.lead(poses);
  tree_.follow(poses);
  for (int i = 0; i < robot_.control_size(); ++i) control_[i] = tree_.control()[i];
  robot_.track(state(), reference, dt_, control_);
}

void PlanDrive::integrate(const Pose* poses, float dt) {
  Lead lead;
  float d[kMaxState];
  robot_.integrate_lead(next(), poses, control_, dt, lead, d);
  robot_.integrate_rest(next(), poses, dt, lead, d);
  for (int i = 0; i < robot_.state_size(); ++i) add(i, d[i]);
}

void PlanDrive::add(int i, float increment) {
  float& state = states_[1 - here_][i];
  float& rest = rests_[1 - here_][i];
  const float sum = state + increment;
  rest = rest + sum_error(state, increment, sum);
  state = sum + rest;
  rest = rest - (state - sum);
}

void PlanDrive::refine() {
  constexpr float kSimpson = 2.0F / 3.0F;  // the weight of the middle, whose rounding counts as a rest
  const int size = robot_.leading_size();
  float first[kMaxState];
  float middle[kMaxState];
  float last[kMaxState];
  float at[kMaxState] = {};  // for compilers that doubt that the size is above 0
  float lost[kMaxState];     // of `at`, by rounding
  rates(state(), first);
  rates(next(), last);
  for (int i = 0; i < size; ++i) at[i] = halfway(i, first[i] - last[i], lost[i]);
  rates(at, middle);
  for (int i = 0; i < size; ++i) {
    move_steadily(i, middle[i], (first[i] - middle[i]) + (last[i] - middle[i]));
    at[i] = at[i] + kMagnified * (0.5F * (rests_[here_][i] + rests_[1 - here_][i]) + kSimpson * lost[i]);
  }
  rates(at, last);
  for (int i = 0; i < size; ++i) add(i, dt_ / kMagnified * (last[i] - middle[i]));
}

float PlanDrive::halfway(int i, float apart, float& lost) const {
  const float sum = state()[i] + next()[i];
  const float bulge = dt_ / 8.0F * apart;
  const float at = 0.5F * sum + bulge;
  lost = 0.5F * sum_error(state()[i], next()[i], sum) + sum_error(0.5F * sum, bulge, at);
  return at;
}

void PlanDrive::move_steadily(int i, float middle, float bend) {
  constexpr float kSame = 1e-5F;  // of the change
  constexpr float kNear = 1e-6F;
  float& next = states_[1 - here_][i];
  float& rest = rests_[1 - here_][i];
  const float change = math::product(middle, dt_);
  const float bent = dt_ / 6.0F * bend;
  const float found = (next - state()[i]) + (rest - rests_[here_][i]);
  if (!(math::absolute(bent) <= kNear)) return;
  if (!(math::absolute((change + bent) - found) <= kSame * math::absolute(change) + kNear)) return;
  next = state()[i];
  rest = rests_[here_][i];
  add(i, change);
  add(i, product_error(middle, dt_, change) + bent);
}

float PlanDrive::sum_error(float a, float b, float sum) {
  const float added = sum - a;
  return (a - (sum - added)) + (b - added);
}

float PlanDrive::product_error(float a, float b, float rounded) {
  const auto high = [](float x) {
    constexpr float kSplitter = 4097.0F;
    const float scaled = kSplitter * x;
    return scaled - (scaled - x);
  };
  const float ah = high(a);
  const float bh = high(b);
  const float al = a - ah;
  const float bl = b - bh;
  return ((ah * bh - rounded) + ah * bl + al * bh) + al * bl;
}

}  // namespace krait::detail
