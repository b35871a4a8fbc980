// SPDX-License-Identifier: Apache-2.0
// OMPL's planners, each with the parameters that served it best on the shipped scenes.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/control/SpaceInformation.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "peers/problem.hpp"

namespace krait::bench {

struct PeerPlanner {
  std::string name;
  ControlKind controls;
  Stop stop;  // PeerMotion's
  PeerTuning tuning;
  std::function<ompl::base::PlannerPtr(const ompl::control::SpaceInformationPtr& space, const PeerProblem& problem)>
      make;
  std::string description;  // a line for the page of results
};

const std::vector<PeerPlanner>& peer_planners();

// Throws host::InputError if there is none of that name.
const PeerPlanner& peer_planner(const std::string& name);

// The planner's tuning, changed by names. Throws host::InputError that lists the names, or has the range.
PeerTuning tuned(const PeerPlanner& planner, const std::map<std::string, double>& settings);

}  // namespace krait::bench
