// SPDX-License-Identifier: Apache-2.0
// A search by one of OMPL's planners, timed and taken out as run_search does for the core's.
#pragma once

#include "host/run/run.hpp"
#include "peers/planners.hpp"

namespace krait::bench {

// Memory, iterations and the name of the planner have no effect. Throws host::InputError where start, goal or robot
// cannot be used. Only the first call of a process is reproducible: OMPL
// seeds its random numbers once.
host::SearchResult solve(const PeerPlanner& planner, const PeerTuning& tuning, const std::string& scene_path,
                         const host::SceneBytes& bytes, const host::SearchRequest& request);

}  // namespace krait::bench
