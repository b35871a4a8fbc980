#include "host/verify/verify.hpp"

#include <cmath>

#include "host/verify/agreement.hpp"
#include "host/verify/comparison.hpp"
#include "host/verify/complaints.hpp"
#include "host/verify/drive.hpp"
#include "host/verify/dynamics.hpp"
#include "host/verify/limits.hpp"
#include "host/verify/obstacles.hpp"
#include "host/verify/sweep.hpp"

namespace krait::host {
namespace {

// What the checks of a plan of sound form share. Positions are relative to the lower corner of the workspace.
struct Judgement {
  const Workspace& workspace;
  const PlanFile& plan;
  const Asked& asked;
  const Dynamics& dynamics;
  const Obstacles& obstacles;
  Complaints& complaints;
  Verdict& verdict;

  State stored(std::size_t index) const {
    const std::vector<float>& row = plan.states[index];
    State state(row.begin(), row.end());
    state[0] += plan.origin.x - workspace.min.x;
    state[1] += plan.origin.y - workspace.min.y;
    return state;
  }
  Control control(std::size_t index) const {
    const std::vector<float>& row = plan.controls[index];
    return {row.begin(), row.end()};
  }
  double goal_depth(const State& state) const {
    return host::goal_depth(asked, {state[0] + workspace.min.x, state[1] + workspace.min.y});
  }
};

// The states that the controls lead to from the plan's first state, one a stored state, or fewer where the robot
// moves too far to be followed. All of the motion is held to the limits and swept.
std::vector<State> drive(const Judgement& j) {
  const Drive drive(j.asked.robot, j.dynamics);
  LimitCheck limits(j.dynamics, j.complaints);
  Sweep sweep(j.asked.robot, j.dynamics, j.obstacles, j.complaints);
  std::vector<State> driven{j.stored(0)};
  limits.check_state("start", driven[0]);
  sweep.check_pose("start", driven[0]);
  for (std::size_t i = 0; i < j.plan.controls.size(); ++i) {
    const std::string step = "step " + text(i);
    const Control control = j.control(i);
    limits.check_control(step, control);
    const std::optional<Leg> leg = drive.leg(driven.back(), control, j.plan.dt);
    if (!leg) {
      j.complaints.add(step + ": moves too far to be followed");
      break;
    }
    limits.check_leg(step, *leg, j.plan.dt);
    sweep.check_leg(step, *leg, j.plan.dt);
    driven.push_back(leg->states.back());
  }
  j.verdict.clearance = sweep.clearance();
  j.verdict.self_clearance = sweep.self_clearance();
  j.verdict.sweep_error = sweep.stray();
  return driven;
}

// Each stored state lies where the controls lead, keeps the limits and is free, and so is the way to it from there.
// The first that disagrees ends this: it explains all that follows.
void check_stored(const Judgement& j, const std::vector<State>& driven) {
  Comparison comparison(j.dynamics, j.plan.dt, j.complaints);
  LimitCheck limits(j.dynamics, j.complaints);
  Sweep sweep(j.asked.robot, j.dynamics, j.obstacles, j.complaints);
  const bool sound = j.complaints.empty();
  double length = 0;
  for (std::size_t i = 0; i < driven.size(); ++i) {
    if (i > 0) length += std::hypot(driven[i][0] - driven[i - 1][0], driven[i][1] - driven[i - 1][1]);
    const State stored = j.stored(i);
    comparison.add(driven[i], length, stored, j.plan.states[i]);
    if (!sound || comparison.failed()) continue;
    const std::string state = "state " + text(i) + " as stored";
    limits.check_state(state, stored);
    sweep.check_between(state, driven[i], stored);
  }
  j.verdict.drift = comparison.worst_difference();
  j.verdict.step_error = comparison.worst_change();
}

void check_end(const Judgement& j, const State& driven) {
  j.verdict.goal_depth = j.goal_depth(driven);
  const double stored = j.goal_depth(j.stored(j.plan.states.size() - 1));
  if (!(j.verdict.goal_depth >= 0)) {
    j.complaints.add("goal: the driven end lies " + text(-j.verdict.goal_depth) + " m outside");
  } else if (!(stored >= 0)) {
    j.complaints.add("goal: the last state lies " + text(-stored) + " m outside");
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
    check_dt(plan, asked, complaints);
    check_start(plan, asked.start, dynamics, complaints);
    check_goal(plan, asked, complaints);
    const Judgement judgement{workspace, plan, asked, dynamics, obstacles, complaints, verdict};
    const std::vector<State> driven = drive(judgement);
    if (driven.size() == plan.states.size()) check_end(judgement, driven.back());
    check_stored(judgement, driven);
  }
  verdict.holds = complaints.empty();
  verdict.complaints = complaints.lines();
  return verdict;
}

}  // namespace krait::host
