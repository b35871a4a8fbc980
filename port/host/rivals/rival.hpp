// SPDX-License-Identifier: Apache-2.0
// What the planners that the paper compares with have in place of Parameters: of the adaptive planner's parameters they
// have no use for those by which it looks ahead, keeps states back, restarts and ends at rest.
#pragma once

#include "krait/parameters.hpp"
#include "search/search.hpp"

namespace krait::rivals {

using namespace detail;  // rivals are made of the core's parts

// They drive where nothing has looked: the share of the top speed from which on set-points are uniform.
inline constexpr float kRivalsSlowest = 0.75F;

inline Parameters of_rival(Parameters parameters) {
  parameters.tuning.open_steps = 0;
  parameters.tuning.goal_near_radius = parameters.tuning.near_radius;
  parameters.tuning.doomed_steps = 0;
  parameters.tuning.restart_unit = 0;
  parameters.tuning.slowest = kRivalsSlowest;
  parameters.end_speed = kInfinity;
  return parameters;
}

}  // namespace krait::rivals
