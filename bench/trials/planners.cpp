// SPDX-License-Identifier: Apache-2.0
#include "trials/planners.hpp"

#include <charconv>

#include "host/workspace/workspace.hpp"

namespace krait::bench {
namespace {

using host::InputError;

// Edge costs never change, and no target strays: what is left of Algorithm 1 without its adaptation.
Parameters static_costs(Parameters parameters) {
  parameters.tuning.gamma = 0.0F;
  parameters.tuning.stray_share = 0.0F;
  return parameters;
}

// Portals that the robot cannot pass stay edges, as in the paper: the search has to find out.
Parameters unpruned(Parameters parameters) {
  parameters.tuning.prune_portals = false;
  return parameters;
}

}  // namespace

const std::vector<CorePlanner>& core_planners() {
  static const std::vector<CorePlanner> planners = {
      {"adaptive", "adaptive", {}, "krait as it ships"},
      {"prior", "prior", {}, "[18]: edge costs never change, 15 % of the targets are random"},
      {"rrt", "rrt", {}, "RRT that connects, goal bias 5 %"},
      {"control", "adaptive", static_costs({}), "krait without adaptation and without random targets"},
      {"plain",
       "plain",
       {},
       "krait the plain way: full Dijkstra, all weights anew for each choice, Box2D for every body and pair, no "
       "tables"},
      {"adaptive-unpruned", "adaptive", unpruned({}), "krait that has to find out which portals are too narrow"},
      {"prior-unpruned", "prior", unpruned({}), "[18], which has to find out as well"},
      {"paper", "adaptive", Parameters::paper(), "the paper's constants: states are checked, not the steps between"}};
  return planners;
}

const CorePlanner& core_planner(const std::string& name) {
  std::string known;
  for (const CorePlanner& planner : core_planners()) {
    if (name == planner.name) return planner;
    known += (known.empty() ? "" : ", ") + std::string(planner.name);
  }
  throw InputError("no planner '" + name + "' (there is: " + known + ")");
}

void set_parameter(const std::string& setting, Parameters& parameters) {
  const std::size_t equals = setting.find('=');
  const std::string name = setting.substr(0, equals);
  const char* begin = setting.data() + (equals == std::string::npos ? setting.size() : equals + 1);
  const char* end = setting.data() + setting.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || rest != end) throw InputError("--set " + setting + ": give NAME=NUMBER");
  if (name == "alpha") {
    parameters.tuning.alpha = static_cast<float>(value);
  } else if (name == "beta") {
    parameters.tuning.beta = static_cast<float>(value);
  } else if (name == "gamma") {
    parameters.tuning.gamma = static_cast<float>(value);
  } else if (name == "kappa" && value >= 0 && value <= UINT32_MAX) {
    parameters.tuning.kappa = static_cast<std::uint32_t>(value);
  } else {
    throw InputError("--set " + setting + ": known are alpha, beta, gamma and kappa, within their ranges");
  }
}

}  // namespace krait::bench
