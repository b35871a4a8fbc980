// SPDX-License-Identifier: Apache-2.0
// The adaptive search without what makes it fast, for comparison: Dijkstra for all regions each time, every group's
// weight again for each choice, and Box2D for every body and every pair of bodies, without the scene's tables.
#pragma once

#include "search/adaptive_search.hpp"

namespace krait::rivals {

// Used as krait::Planner is, and finds the same plan.
class PlainPlanner : public detail::AdaptiveSearch {
 public:
  PlainPlanner() { shortcuts_ = false; }
};

}  // namespace krait::rivals
