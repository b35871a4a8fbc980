// SPDX-License-Identifier: Apache-2.0
// How a plan is improved by multiples of the collision checks that the first one cost. The workstation includes this
// too, so that both come to the same plan, given the same block.
#pragma once

#include <algorithm>
#include <cstdint>

#include "krait/planner.hpp"

namespace krait::firmware {

// Limits::way_legs: none where nothing is to be improved, else one a kilobyte of the block, up to those of long plans.
inline std::uint32_t way_legs(std::uint64_t bytes, double multiples) {
  if (!(multiples > 0)) return 0;
  return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(bytes / 1024, Limits::kLeastLegs, 4096));
}

// Initialises a planner with that room. Where the block is too small, bytes_needed is enough for the room as well,
// which grows with the block.
template <class P>
Failure init_with_room(P& planner, const Setup& setup, const Parameters& parameters, std::uint64_t iterations,
                       double multiples) {
  const auto init = [&](std::uint64_t bytes) {
    return planner.init(setup, parameters, {.iterations = iterations, .way_legs = way_legs(bytes, multiples)});
  };
  std::uint64_t bytes = setup.bytes;
  Failure ready = init(bytes);
  while (ready.status == Status::arena_too_small && ready.bytes_needed > bytes) {
    bytes = ready.bytes_needed;
    ready = init(bytes);
  }
  return ready;
}

// Improves the plan by iterations, which iterate() makes and says whether more are wanted, until `multiples` times the
// first plan's collision checks are made. An iteration counts as a quarter of a check besides those that it makes, so
// that those that check nothing come to an end.
template <class P, class Iterate>
void improve(const P& planner, double multiples, Iterate iterate) {
  const std::uint64_t first = planner.statistics().collision_checks;
  const double checks = multiples * static_cast<double>(first);
  double idle = 0;
  const auto done = [&] { return static_cast<double>(planner.statistics().collision_checks - first) + idle; };
  while (done() < checks && iterate()) idle += 0.25;
}

// The counts of the search for the first plan, with the measures of the best one.
inline Statistics with_plan_of(const Statistics& found, const Statistics& best) {
  Statistics both = found;
  both.bytes_used = best.bytes_used;
  both.improvements = best.improvements;
  both.plan_steps = best.plan_steps;
  both.plan_length = best.plan_length;
  both.plan_duration = best.plan_duration;
  both.plan_end_speed = best.plan_end_speed;
  both.hash = best.hash;
  return both;
}

}  // namespace krait::firmware
