// SPDX-License-Identifier: Apache-2.0
// The planners of the core that are measured: each a name for a search and its parameters.
#pragma once

#include <string>
#include <vector>

#include "krait/parameters.hpp"

namespace krait::bench {

struct CorePlanner {
  const char* name;
  const char* search;  // as krait plan --planner has it
  Parameters parameters;
  const char* description;  // a line for the page of results
};

const std::vector<CorePlanner>& core_planners();

// Throws host::InputError if there is none of that name.
const CorePlanner& core_planner(const std::string& name);

// Sets one parameter from "alpha=4" (or beta, gamma, kappa). Throws host::InputError.
void set_parameter(const std::string& setting, Parameters& parameters);

}  // namespace krait::bench
