// SPDX-License-Identifier: Apache-2.0
// Plans with the core alone: krait::Planner through the public headers.
#pragma once

#include <string>
#include <vector>

#include "judge.hpp"
#include "krait/goal.hpp"
#include "krait/parameters.hpp"

namespace krait::campaign {

struct Query {
  Robot robot;
  Parameters parameters;
  std::vector<float> start;  // a state, in the scene's coordinates
  Goal goal = Goal::named(0);
  std::uint64_t seed = 1;
  std::uint64_t bytes = 16U << 20U;  // of the block
  std::uint64_t iterations = 1'000'000;
  std::uint64_t work = ~0ULL;  // placements of a body after which the search is given up
};

struct Planned {
  std::string end;  // the status; of a refusal with the argument; "work_used" where the search was given up
  bool solved = false;
  PlanRecord plan;
};

Planned plan(const Scene& scene, const Query& query);

}  // namespace krait::campaign
