// SPDX-License-Identifier: Apache-2.0
#include "trials/planners.hpp"

#include <cmath>
#include <variant>

#include "krait/status.hpp"
#include "trials/named.hpp"

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

// A parameter that a trial may set.
struct Setting {
  std::string name;
  std::variant<float Parameters::*, float SearchTuning::*, std::uint32_t SearchTuning::*, bool SearchTuning::*> member;
  Argument argument = Argument::none;  // whose range it has; none of a switch, which is 0 or 1

  void set(double value, Parameters& parameters) const {
    refuse(value);
    if (const auto* of_motion = std::get_if<float Parameters::*>(&member)) {
      parameters.*(*of_motion) = static_cast<float>(value);
    } else if (const auto* real = std::get_if<float SearchTuning::*>(&member)) {
      parameters.tuning.*(*real) = static_cast<float>(value);
    } else if (const auto* count = std::get_if<std::uint32_t SearchTuning::*>(&member)) {
      parameters.tuning.*(*count) = static_cast<std::uint32_t>(value);
    } else {
      parameters.tuning.*(std::get<bool SearchTuning::*>(member)) = value != 0;
    }
  }

 private:
  void refuse(double value) const {
    const ParameterRange range = argument == Argument::none ? ParameterRange{0, 1} : Parameters::range(argument);
    refuse_outside(name, value, static_cast<double>(range.least), static_cast<double>(range.most));
    const bool whole = std::holds_alternative<std::uint32_t SearchTuning::*>(member) ||
                       std::holds_alternative<bool SearchTuning::*>(member);
    if (whole && value != std::floor(value)) throw InputError("set " + name + ": must be without a fraction");
  }
};

const std::vector<Setting>& settings_of_searches() {
  static const std::vector<Setting> settings = {
      {"goal_margin", &Parameters::goal_margin, Argument::goal_margin},
      {"end_speed", &Parameters::end_speed, Argument::end_speed},
      {"alpha", &SearchTuning::alpha, Argument::alpha},
      {"beta", &SearchTuning::beta, Argument::beta},
      {"gamma", &SearchTuning::gamma, Argument::gamma},
      {"kappa", &SearchTuning::kappa, Argument::kappa},
      {"cost_length", &SearchTuning::cost_length, Argument::cost_length},
      {"group_sample", &SearchTuning::group_sample, Argument::group_sample},
      {"open_steps", &SearchTuning::open_steps, Argument::open_steps},
      {"path_lengths", &SearchTuning::path_lengths, Argument::path_lengths},
      {"goal_near_radius", &SearchTuning::goal_near_radius, Argument::goal_near_radius},
      {"stray_share", &SearchTuning::stray_share, Argument::stray_share},
      {"gentle_share", &SearchTuning::gentle_share, Argument::gentle_share},
      {"sight_tries", &SearchTuning::sight_tries, Argument::sight_tries},
      {"candidates", &SearchTuning::candidates, Argument::candidates},
      {"doomed_steps", &SearchTuning::doomed_steps, Argument::doomed_steps},
      {"restart_unit", &SearchTuning::restart_unit, Argument::restart_unit},
      {"stuck_expansions", &SearchTuning::stuck_expansions, Argument::stuck_expansions},
      {"update_regions", &SearchTuning::update_regions, Argument::update_regions},
      {"slowest", &SearchTuning::slowest, Argument::slowest},
      {"stopping_ways", &SearchTuning::stopping_ways, Argument::stopping_ways},
      {"raise_goal", &SearchTuning::raise_goal},
      {"continuous", &SearchTuning::continuous},
      {"prune_portals", &SearchTuning::prune_portals}};
  return settings;
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
       "krait the plain way: full Dijkstra, all weights recomputed for each choice, Box2D for every body and pair, no "
       "tables"},
      {"adaptive-unpruned", "adaptive", unpruned({}), "krait that has to find out which portals are too narrow"},
      {"prior-unpruned", "prior", unpruned({}), "[18], which has to find out as well"},
      {"paper", "adaptive", Parameters::paper(),
       "the paper's method and constants: states are checked, not the steps between"},
      {"paper-prior", "prior", Parameters::paper(), "[18] under the paper's conditions"},
      {"paper-rrt", "rrt", Parameters::paper(), "RRT under the paper's conditions"}};
  return planners;
}

const CorePlanner& core_planner(const std::string& name) { return named(core_planners(), "planner", name); }

void set_parameters(const std::map<std::string, double>& settings, Parameters& parameters) {
  for (const auto& [name, value] : settings) named(settings_of_searches(), "setting", name).set(value, parameters);
}

}  // namespace krait::bench
