// SPDX-License-Identifier: Apache-2.0
#include "host/cli/asked.hpp"

namespace krait::host {
namespace {

// `form` is that of the option, whose name `what` is.
template <class Named>
const Named& by_name(const std::vector<Named>& all, const std::string& name, const std::string& what,
                     const char* form) {
  if (name.empty() && !all.empty()) return all.front();
  for (const Named& one : all) {
    if (one.name == name) return one;
  }
  throw InputError(name.empty() ? "the input has no " + what + ": give --" + what + " " + form
                                : "the input has no " + what + " '" + name + "'");
}

}  // namespace

Asked asked_of(const Workspace& workspace, const SearchRequest& request) {
  Asked asked;
  asked.robot = request.robot;
  asked.dt = static_cast<double>(request.parameters.dt);
  asked.end_speed = request.end_speed();
  asked.facing = request.facing;
  asked.start = request.start ? Start{"start", request.start->position, request.start->heading, {}}
                              : by_name(workspace.starts, request.start_name, "start", "X,Y,HEADING");
  if (request.goal) {
    asked.disc_center = request.goal->center;
    asked.disc_radius = request.goal->radius;
  } else {
    asked.goal = by_name(workspace.goals, request.goal_name, "goal", "X,Y,RADIUS").polygon;
  }
  return asked;
}

Verdict judged(const Workspace& workspace, const PlanFile& plan, const Asked& asked, Progress& progress) {
  const std::string all = " of " + std::to_string(plan.controls.size()) + " steps";
  progress.show("verifying", "0" + all);
  return verify(workspace, plan, asked,
                [&](std::size_t step) { progress.show("verifying", std::to_string(step) + all); });
}

}  // namespace krait::host
