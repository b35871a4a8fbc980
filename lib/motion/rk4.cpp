// SPDX-License-Identifier: Apache-2.0
#include "motion/rk4.hpp"

namespace krait::detail {

float longest_step(const Robot& robot, float dt, float step_rate) {
  const float rate = robot.fastest_rate(dt);
  return rate == 0.0F ? kInfinity : step_rate / rate;
}

float longest_tree_step(const Robot& robot, float dt) { return longest_step(robot, dt, kStepRate); }

float longest_plan_step(const Robot& robot, float dt) {
  const bool follows = robot.leading_size() < robot.state_size() && !robot.reversible();
  return longest_step(robot, dt, follows ? kPlanStepRate : kFinePlanStepRate);
}

bool can_integrate(const Robot& robot, float dt) {
  return dt <= static_cast<float>(kMostParts) * longest_tree_step(robot, dt);
}

float longest_time_step(const Robot& robot, float dt) {
  float fits = 0.001F;
  if (!can_integrate(robot, fits)) return 0.0F;
  float too_long = dt;
  for (int halving = 0; halving < 24; ++halving) {
    const float middle = 0.5F * (fits + too_long);
    (can_integrate(robot, middle) ? fits : too_long) = middle;
  }
  return fits;
}

void Motion::lead(const Robot& robot, const float* state, const Pose* poses, const float* control, float dt,
                  float* next) {
  robot.integrate_lead(state, poses, control, dt, lead_, next);
  const int end = first_of_rest(robot);
  for (int i = 0; i < end; ++i) next[i] = state[i] + next[i];
}

void Motion::follow(const Robot& robot, const float* state, const Pose* poses, float dt, float* next) const {
  robot.integrate_rest(state, poses, dt, lead_, next);
  const int end = robot.state_size();
  for (int i = first_of_rest(robot); i < end; ++i) next[i] = state[i] + next[i];
}

void propagate(const Robot& robot, const float* state, const Pose* poses, const float* control, float dt, float* next) {
  Motion motion;
  motion.lead(robot, state, poses, control, dt, next);
  motion.follow(robot, state, poses, dt, next);
}

void propagate(const Robot& robot, const float* state, const float* control, float dt, float* next) {
  Pose poses[kMaxBodies];
  robot.place(state, poses);
  propagate(robot, state, poses, control, dt, next);
}

void propagate_in_parts(const Robot& robot, const float* state, const Pose* poses, const float* control, float dt,
                        int parts, float* next) {
  const int size = robot.state_size();
  const float part = dt / static_cast<float>(parts);
  propagate(robot, state, poses, control, part, next);
  float from[kMaxState];
  for (int done = 1; done < parts; ++done) {
    for (int i = 0; i < size; ++i) from[i] = next[i];
    propagate(robot, from, control, part, next);
  }
}

}  // namespace krait::detail
