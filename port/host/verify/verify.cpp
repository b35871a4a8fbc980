// SPDX-License-Identifier: Apache-2.0
#include "host/verify/verify.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/verify/agreement.hpp"
#include "host/verify/comparison.hpp"
#include "host/verify/complaints.hpp"
#include "host/verify/drive.hpp"
#include "host/verify/dynamics.hpp"
#include "host/verify/limits.hpp"
#include "host/verify/obstacles.hpp"
#include "host/verify/statistics.hpp"
#include "host/verify/sweep.hpp"

namespace krait::host {
namespace {

// A plan that is refused already may be absurd in any way: so much more is looked at, bodies times sub-steps.
constexpr std::size_t kMostWorkOnceRefused = 500'000;
constexpr double kEndSpeedTolerance = 1e-2;  // m/s

// Holds the motion of a plan of sound form, and then its stored states, to what was asked. Positions are relative to
// the lower corner of the workspace.
class Judge {
 public:
  // Keeps references.
  Judge(const Workspace& workspace, const PlanFile& plan, const Asked& asked, const Dynamics& dynamics,
        const Obstacles& obstacles, Complaints& complaints)
      : workspace_(workspace),
        plan_(plan),
        asked_(asked),
        dynamics_(dynamics),
        complaints_(complaints),
        drive_(asked.robot, dynamics),
        limits_(dynamics, complaints),
        sweep_(asked.robot, dynamics, obstacles, complaints),
        comparison_(dynamics, plan.dt, of_states_),
        stored_limits_(dynamics, of_states_),
        stored_sweep_(asked.robot, dynamics, obstacles, of_states_),
        state_(stored(0)) {}

  void judge(Verdict& verdict, const std::function<void(std::size_t)>& tell) {
    limits_.check_state("start", state_);
    sweep_.check_pose("start", state_);
    check_stored(0);
    bool driven = true;
    for (std::size_t i = 0; driven && i < plan_.controls.size(); ++i) {
      if (tell) tell(i);
      driven = drive(i);
    }
    if (driven) check_end(verdict);
    complaints_.append(of_states_);
    verdict.step_error = comparison_.worst_change();
    verdict.drift = comparison_.worst_difference();
    verdict.clearance = sweep_.clearance();
    verdict.self_clearance = sweep_.self_clearance();
    verdict.sweep_error = sweep_.stray();
  }

 private:
  State stored(std::size_t index) const {
    const std::vector<float>& row = plan_.states[index];
    State state(row.begin(), row.end());
    state[0] += plan_.origin.x - workspace_.min.x;
    state[1] += plan_.origin.y - workspace_.min.y;
    return state;
  }

  // Moves on by one control. False where that cannot be followed, or is not worth it.
  bool drive(std::size_t index) {
    const std::string step = "step " + text(index);
    const Control control(plan_.controls[index].begin(), plan_.controls[index].end());
    limits_.check_control(step, control);
    const std::optional<Leg> leg = drive_.leg(state_, control, plan_.dt);
    if (!leg) {
      complaints_.add(step + ": moves too far to be followed");
      return false;
    }
    if (!may_spend(leg->poses.size() * dynamics_.body_count())) {
      complaints_.add(step + ": from here on the refused plan is not looked at");
      return false;
    }
    limits_.check_leg(step, *leg, plan_.dt);
    sweep_.check_leg(step, *leg, plan_.dt);
    const State& to = leg->states.back();
    length_ += std::hypot(to[0] - state_[0], to[1] - state_[1]);
    state_ = to;
    check_stored(index + 1);
    return true;
  }

  bool may_spend(std::size_t work) {
    if (complaints_.empty() && of_states_.empty()) return true;
    work_once_refused_ += work;
    return work_once_refused_ <= kMostWorkOnceRefused;
  }

  // A stored state lies where the controls lead, keeps the limits and is free, and so is the way to it from there. The
  // first that disagrees explains those that follow, and a motion that is at fault explains its states.
  void check_stored(std::size_t index) {
    const State state = stored(index);
    comparison_.add(state_, length_, state, plan_.states[index]);
    if (!complaints_.empty() || comparison_.failed()) return;
    const std::string where = "state " + text(index) + " as stored";
    stored_limits_.check_state(where, state);
    stored_sweep_.check_between(where, state_, state);
  }

  double depth(const State& state) const {
    return goal_depth(asked_, {state[0] + workspace_.min.x, state[1] + workspace_.min.y});
  }

  void check_end(Verdict& verdict) {
    const State end = stored(plan_.states.size() - 1);
    verdict.goal_depth = depth(state_);
    const double last = depth(end);
    if (!(verdict.goal_depth >= 0)) {
      complaints_.add("goal: the driven end lies " + text(-verdict.goal_depth) + " m outside");
    } else if (!(last >= 0)) {
      complaints_.add("goal: the last state lies " + text(-last) + " m outside");
    }
    if (asked_.facing) {
      verdict.heading_error = heading_error(state_, *asked_.facing);
      if (!check_facing("the driven end", state_)) check_facing("the last state", end);
    }
    verdict.end_speed = dynamics_.speed(state_);
    if (asked_.end_speed && !check_speed("the driven end", verdict.end_speed)) {
      check_speed("the last state", dynamics_.speed(end));
    }
  }

  // Radians, at least 0, between the frames' x axes.
  static double angle(const Frame& a, const Frame& b) {
    return std::abs(std::atan2(a.cos * b.sin - a.sin * b.cos, a.cos * b.cos + a.sin * b.sin));
  }

  // Radians, from the nearer of the headings that are accepted.
  double heading_error(const State& state, const GoalFacing& facing) const {
    const Frame wanted{{}, std::cos(facing.heading), std::sin(facing.heading)};
    const double error = angle(dynamics_.frames(state).front(), wanted);
    return facing.either_way ? std::min(error, std::numbers::pi - error) : error;
  }

  // Whether it complains.
  bool check_facing(const std::string& where, const State& state) {
    const GoalFacing& facing = *asked_.facing;
    const double error = heading_error(state, facing);
    if (!(error <= facing.tolerance)) {
      complaints_.add("goal: the heading of " + where + " is " + text(error) +
                      " rad from the one asked for, allowed are " + text(facing.tolerance) + " rad");
      return true;
    }
    const std::vector<Frame> frames = dynamics_.frames(state);
    for (std::size_t k = 1; facing.hitches && k < frames.size(); ++k) {
      const double bent = angle(frames[k - 1], frames[k]);
      if (bent <= *facing.hitches) continue;
      complaints_.add("goal: the hitch before body " + text(k) + " of " + where + " is bent by " + text(bent) +
                      " rad, allowed are " + text(*facing.hitches) + " rad");
      return true;
    }
    return false;
  }

  // Whether it complains.
  bool check_speed(const std::string& where, double speed) {
    if (speed <= *asked_.end_speed + kEndSpeedTolerance) return false;
    complaints_.add("end: " + where + " moves at " + text(speed) + " m/s, asked at most " + text(*asked_.end_speed) +
                    " m/s");
    return true;
  }

  const Workspace& workspace_;
  const PlanFile& plan_;
  const Asked& asked_;
  const Dynamics& dynamics_;
  Complaints& complaints_;  // of form and motion
  Complaints of_states_;
  Drive drive_;
  LimitCheck limits_;
  Sweep sweep_;
  Comparison comparison_;
  LimitCheck stored_limits_;
  Sweep stored_sweep_;
  State state_;        // as driven
  double length_ = 0;  // m, driven so far
  std::size_t work_once_refused_ = 0;
};

}  // namespace

Verdict verify(const Workspace& workspace, const PlanFile& plan, const Asked& asked,
               const std::function<void(std::size_t)>& tell) {
  const Dynamics dynamics(asked.robot);
  const Obstacles obstacles(workspace);
  Verdict verdict;
  Complaints complaints;
  check_robot(plan.robot, asked.robot, complaints);
  if (check_form(plan, dynamics, complaints)) {
    check_dt(plan, asked, complaints);
    check_start(plan, asked.start, dynamics, complaints);
    check_goal(plan, asked, complaints);
    Judge(workspace, plan, asked, dynamics, obstacles, complaints).judge(verdict, tell);
    if (complaints.empty()) check_statistics(plan, dynamics, complaints);  // what else is wrong explains them
  }
  verdict.holds = complaints.empty();
  verdict.complaints = complaints.lines();
  return verdict;
}

}  // namespace krait::host
