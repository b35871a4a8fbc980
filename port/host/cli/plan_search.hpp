// SPDX-License-Identifier: Apache-2.0
// The searches of one krait plan, one after another where the first leaves no plan: with less clearance, or with
// obstacles as they are drawn.
#pragma once

#include <optional>

#include "host/cli/clearance.hpp"
#include "host/cli/ground.hpp"
#include "host/cli/plan_options.hpp"
#include "host/input/progress.hpp"
#include "host/run/run.hpp"

namespace krait::host {

// A search and the distance that it kept to obstacles, where --clearance was not set.
struct Answer {
  SearchResult result;
  std::optional<Clearance> clearance;
};

// The clearance that was kept becomes the request's, the scene that was searched the ground's. Throws InputError for
// whatever cannot be used; where --robot was not set, a refusal of start or goal names the robot.
Answer search_for(Ground& ground, const PlanOptions& options, SearchRequest& request, Progress& progress);

}  // namespace krait::host
