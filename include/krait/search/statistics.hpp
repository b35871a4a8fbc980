// SPDX-License-Identifier: Apache-2.0
// What a search has done so far, by the names of the plan's JSON.
#pragma once

#include <cstdint>

namespace krait {

struct Statistics {
  std::uint64_t iterations = 0;  // expansions; of a long one every max_steps steps
  std::uint64_t restarts = 0;
  std::uint64_t vertices = 0;          // that the motion tree grew by
  std::uint64_t recycled = 0;          // of those kept to grow from, given up for want of memory
  std::uint64_t collision_checks = 0;  // placements of the whole robot that were tested
  std::uint64_t dijkstra_runs = 0;
  std::uint64_t regions_repaired = 0;  // by a repair of the shortest paths in place of a run
  std::uint64_t plans_refused = 0;     // ways to the goal that did not hold as driven
  std::uint64_t bytes_used = 0;        // of the block: tables, and what vertices and expansions took at most
  std::uint64_t bytes_given = 0;
  std::uint32_t plan_steps = 0;
  float plan_length = 0.0F;     // metres
  float plan_duration = 0.0F;   // seconds
  float plan_end_speed = 0.0F;  // m/s, of the last state; 0 of a robot whose states have no speed
  std::uint64_t hash = 0;
  std::uint64_t improvements = 0;  // better plans that improve has found
};

}  // namespace krait
