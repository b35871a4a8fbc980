// SPDX-License-Identifier: Apache-2.0
// The planners of the core that are measured: each a name for a search and its parameters.
#pragma once

#include <map>
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

// Changes parameters by their names. Throws host::InputError that lists the names, or has the range.
void set_parameters(const std::map<std::string, double>& settings, Parameters& parameters);

}  // namespace krait::bench
