// SPDX-License-Identifier: Apache-2.0
// OMPL's planners, each with the parameters that served it best on the shipped scenes.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/control/SpaceInformation.h>

#include <functional>
#include <string>
#include <vector>

#include "peers/problem.hpp"

namespace krait::bench {

struct PeerPlanner {
  const char* name;
  ControlKind controls;
  double heading_weight;   // PeerSpace's, metres a radian
  Stop stop;               // PeerMotion's
  unsigned int max_steps;  // a control is held for 1 to that many steps
  std::function<ompl::base::PlannerPtr(const ompl::control::SpaceInformationPtr& space, const PeerProblem& problem)>
      make;
  const char* description;  // a line for the page of results
};

const std::vector<PeerPlanner>& peer_planners();

// Throws host::InputError if there is none of that name.
const PeerPlanner& peer_planner(const std::string& name);

}  // namespace krait::bench
