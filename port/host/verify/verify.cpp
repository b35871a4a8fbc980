#include "host/verify/verify.hpp"

#include <algorithm>
#include <cmath>

#include "host/verify/agreement.hpp"
#include "host/verify/complaints.hpp"
#include "host/verify/dynamics.hpp"
#include "host/verify/obstacles.hpp"
#include "host/verify/sweep.hpp"

namespace krait::host {
namespace {

constexpr std::size_t kSubSteps = 8;
constexpr double kStepTolerance = 5e-3;   // per component
constexpr double kDriftTolerance = 0.05;  // m
constexpr double kLimitTolerance = 1e-4;  // relative

// A plan of sound form in double precision, its positions relative to the lower corner of the workspace.
struct Motion {
  std::vector<State> states;
  std::vector<Control> controls;
  double dt;
};

Motion motion_of(const PlanFile& plan, const Workspace& workspace) {
  Motion motion{{}, {}, plan.dt};
  for (const auto& row : plan.states) {
    State state(row.begin(), row.end());
    state[0] += plan.origin.x - workspace.min.x;
    state[1] += plan.origin.y - workspace.min.y;
    motion.states.push_back(std::move(state));
  }
  for (const auto& row : plan.controls) motion.controls.emplace_back(row.begin(), row.end());
  return motion;
}

Point world_position(const State& state, const Workspace& workspace) {
  return {state[0] + workspace.min.x, state[1] + workspace.min.y};
}

void check_end(const char* what, double depth, Complaints& complaints) {
  if (!(depth >= 0)) complaints.add(std::string("goal: the ") + what + " lies " + text(-depth) + " m outside");
}

void check_replay(const Motion& motion, const Workspace& workspace, const Asked& asked, const Dynamics& dynamics,
                  Verdict& verdict, Complaints& complaints) {
  State state = motion.states.front();
  for (const Control& control : motion.controls) {
    state = dynamics.integrate(state, control, motion.dt, kSubSteps).back();
  }
  const State& stored = motion.states.back();
  verdict.drift = std::hypot(state[0] - stored[0], state[1] - stored[1]);
  if (!(verdict.drift <= kDriftTolerance)) {
    complaints.add("replay: ends " + text(verdict.drift) + " m from the last state (limit " + text(kDriftTolerance) +
                   ")");
  }
  verdict.goal_depth = goal_depth(asked, world_position(state, workspace));
  check_end("replayed end", verdict.goal_depth, complaints);
  check_end("last state", goal_depth(asked, world_position(stored, workspace)), complaints);
}

bool check_limits(const std::string& where, const std::vector<Limited>& quantities, Complaints& complaints) {
  bool holds = true;
  for (const Limited& quantity : quantities) {
    const double slack = kLimitTolerance * std::max(std::abs(quantity.min), std::abs(quantity.max));
    const double excess = std::max(quantity.min - quantity.value, quantity.value - quantity.max);
    if (excess <= slack) continue;
    holds = false;
    complaints.add(where + ": " + quantity.name + " " + text(quantity.value) + " is beyond its limit by " +
                   text(excess));
  }
  return holds;
}

// The stored state, and while they hold the states in between; each step adds the state that it ends with.
void check_step_limits(const std::string& step, const std::vector<State>& between, const State& stored,
                       const Dynamics& dynamics, Complaints& complaints) {
  for (std::size_t i = 1; i < between.size(); ++i) {
    if (!check_limits(step + ", sub-step " + text(i), dynamics.limited(between[i]), complaints)) return;
  }
  check_limits(step + ", its end", dynamics.limited(stored), complaints);
}

double check_step_error(const std::string& step, const State& integrated, const State& stored, const Dynamics& dynamics,
                        Complaints& complaints) {
  double worst = 0;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    const double difference = std::abs(stored[i] - integrated[i]);
    if (!(difference <= kStepTolerance)) {
      complaints.add(step + ": " + dynamics.state_names()[i] + " differs by " + text(difference) +
                     " from the integrated state (limit " + text(kStepTolerance) + ")");
    }
    if (!(difference <= worst)) worst = difference;
  }
  return worst;
}

void check_steps(const Motion& motion, const Dynamics& dynamics, Sweep& sweep, Verdict& verdict,
                 Complaints& complaints) {
  check_limits("start", dynamics.limited(motion.states.front()), complaints);
  sweep.check_pose(motion.states.front());
  verdict.step_error = 0;
  for (std::size_t i = 0; i < motion.controls.size() && !complaints.enough(); ++i) {
    const std::string step = "step " + text(i);
    const Control& control = motion.controls[i];
    const State& from = motion.states[i];
    const State& to = motion.states[i + 1];
    const std::vector<State> between = dynamics.integrate(from, control, motion.dt, kSubSteps);
    verdict.step_error = std::max(check_step_error(step, between.back(), to, dynamics, complaints), verdict.step_error);
    check_limits(step, dynamics.limited_controls(control), complaints);
    check_step_limits(step, between, to, dynamics, complaints);
    sweep.check_step(i, from, control, motion.dt, to);
  }
}

}  // namespace

Verdict verify(const Workspace& workspace, const PlanFile& plan, const Asked& asked) {
  const Dynamics dynamics(asked.robot);
  const Obstacles obstacles(workspace);
  Verdict verdict;
  Complaints complaints;
  check_robot(plan.robot, asked.robot, complaints);
  if (check_form(plan, dynamics, complaints)) {
    check_start(plan, asked.start, dynamics, complaints);
    check_goal(plan, asked, complaints);
    const Motion motion = motion_of(plan, workspace);
    check_replay(motion, workspace, asked, dynamics, verdict, complaints);
    Sweep sweep(asked.robot, dynamics, obstacles, complaints);
    check_steps(motion, dynamics, sweep, verdict, complaints);
    verdict.clearance = sweep.clearance();
    verdict.self_clearance = sweep.self_clearance();
    verdict.sweep_error = sweep.sweep_error();
  }
  verdict.holds = complaints.empty();
  verdict.complaints = complaints.lines();
  return verdict;
}

}  // namespace krait::host
