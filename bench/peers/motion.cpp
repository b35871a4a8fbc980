// SPDX-License-Identifier: Apache-2.0
#include "peers/motion.hpp"

#include <algorithm>

#include "krait/math.hpp"
#include "motion/rk4.hpp"
#include "robot/shape.hpp"

namespace krait::bench {
namespace {

using ValueControl = ompl::control::RealVectorControlSpace::ControlType;

constexpr float kLimitRounding = 1e-5F;  // relative: how far inside its limits a random control keeps the state

// The rate nearest to `wanted` that keeps a component within its limits for a step.
float saturated(float wanted, float value, const ControlAxis& axis, float dt) {
  const float slack = kLimitRounding * (axis.most - axis.least);
  return math::clamp(wanted, (axis.least + slack - value) / dt, (axis.most - slack - value) / dt);
}

void random_control(const PeerProblem& problem, const float* state, const double* values, float* held) {
  for (const ControlAxis& axis : problem.robot.axes()) {
    const auto wanted = static_cast<float>(*values++);
    const float kept =
        axis.component < 0 ? wanted : saturated(wanted, state[axis.component], axis, problem.parameters.dt);
    *held++ = math::clamp(kept, axis.low, axis.high);
  }
}

void steered_control(const PeerProblem& problem, const float* state, const double* values, float* held) {
  const Target target{{static_cast<float>(values[0]), static_cast<float>(values[1])},
                      static_cast<float>(values[2]),
                      problem.parameters.dt,
                      static_cast<float>(values[3])};
  problem.robot.steer(state, target, held);
}

}  // namespace

void robot_control(const PeerProblem& problem, const float* state, const ompl::control::Control* control, float* held) {
  const double* values = control->as<ValueControl>()->values;
  if (problem.controls == ControlKind::pid) {
    steered_control(problem, state, values, held);
  } else {
    random_control(problem, state, values, held);
  }
}

PeerMotion::PeerMotion(const PeerProblem& problem, Stop stop)
    : problem_(problem), robot_(problem.robot.core()), stop_(stop) {
  check_.assign(robot_, problem.scene, problem.parameters.clearance,
                static_cast<int>(problem.parameters.tuning.max_substeps), true);
}

void PeerMotion::take_step(const PeerState& from, const ompl::control::Control* control, PeerState& to) {
  std::copy(from.values, from.values + robot_.state_size(), last_.from);
  last_.from_origin = from.origin;
  last_.target_distance = kInfinity;
  if (problem_.controls == ControlKind::pid) {
    const double* values = control->as<ValueControl>()->values;
    const Vec2 target{static_cast<float>(values[0]), static_cast<float>(values[1])};
    last_.target_distance = length(target - from.position());
  }
  robot_control(problem_, last_.from, control, last_.held);
  detail::propagate(robot_, last_.from, last_.held, problem_.parameters.dt, to.values);
  to.origin = ++last_.number;
}

bool PeerMotion::valid(const PeerState& state) {
  if (state.origin == PeerState::kAssumed) return true;
  return state.origin == last_.number && state.origin != PeerState::kSampled ? last_step_free(state)
                                                                             : at_rest_valid(state);
}

bool PeerMotion::at_rest_valid(const PeerState& state) {
  proven_ = PeerState::kSampled;
  return problem_.scene.inside_bounds(state.position()) && robot_.within_limits(state.values) &&
         check_.free(state.values);
}

bool PeerMotion::ended_before_last_step() const {
  if (stop_ == Stop::never) return false;
  const float near = problem_.parameters.tuning.near_radius * detail::robot_length(robot_);
  return (problem_.tuning.stop_at_target != 0 && last_.target_distance <= near) ||
         in_goal(problem_, {last_.from[0], last_.from[1]});
}

bool PeerMotion::last_step_free(const PeerState& to) {
  if (ended_before_last_step()) return false;
  if (!robot_.within_limits(to.values) || !problem_.scene.inside_bounds(to.position())) return false;
  const float dt = problem_.parameters.dt;
  const bool goes_on = last_.from_origin == proven_ && proven_ != PeerState::kSampled;
  if (!goes_on) check_.begin(last_.from);
  const bool free = check_.step_free(last_.from, last_.held, dt, to.values);
  proven_ = free ? to.origin : PeerState::kSampled;
  return free;
}

void PeerPropagator::propagate(const ompl::base::State* state, const ompl::control::Control* control, double,
                               ompl::base::State* result) const {
  motion_.take_step(peer(state), control, peer(result));
}

}  // namespace krait::bench
