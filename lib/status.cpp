// SPDX-License-Identifier: Apache-2.0
#include "krait/status.hpp"

#include <cstddef>
#include <iterator>

namespace krait {
namespace {

// The enumerators, whose names are their texts, in their order.
// clang-format off
#define KRAIT_STATUSES(NAME)                                                                                       \
  NAME(ok) NAME(ready) NAME(searching) NAME(solved) NAME(no_route) NAME(budget_used) NAME(tree_full)               \
  NAME(time_used) NAME(bad_scene) NAME(bad_robot) NAME(bad_argument) NAME(start_outside) NAME(start_in_collision)  \
  NAME(goal_in_obstacle) NAME(arena_too_small) NAME(bad_arithmetic) NAME(internal)
#define KRAIT_ARGUMENTS(NAME)                                                                                      \
  NAME(none) NAME(block) NAME(scene) NAME(start) NAME(goal) NAME(iterations) NAME(vertices) NAME(expansions)       \
  NAME(when_full) NAME(way_legs) NAME(alpha) NAME(beta) NAME(gamma) NAME(kappa) NAME(update_regions)               \
  NAME(group_sample) NAME(epsilon) NAME(dt) NAME(max_steps) NAME(open_steps) NAME(path_regions) NAME(path_lengths) \
  NAME(near_radius) NAME(goal_near_radius) NAME(clearance) NAME(stray_share) NAME(gentle_share)                    \
  NAME(sight_tries) NAME(candidates) NAME(least_sketch) NAME(doomed_steps) NAME(restart_unit)                      \
  NAME(stuck_expansions) NAME(slowest) NAME(stopping_ways) NAME(reverse_share) NAME(cost_length) NAME(goal_margin) \
  NAME(end_speed) NAME(max_substeps) NAME(robot_dimensions) NAME(robot_polygon) NAME(robot_sizes)
// clang-format on

#define KRAIT_TEXT(name) #name "\0"
#define KRAIT_STATUS(name) Status::name,
#define KRAIT_ARGUMENT(name) Argument::name,
constexpr char kStatusNames[] = KRAIT_STATUSES(KRAIT_TEXT) "unknown";
constexpr char kArgumentNames[] = KRAIT_ARGUMENTS(KRAIT_TEXT) "unknown";
constexpr Status kStatuses[] = {KRAIT_STATUSES(KRAIT_STATUS)};
constexpr Argument kArguments[] = {KRAIT_ARGUMENTS(KRAIT_ARGUMENT)};

// Whether these are all enumerators up to the last, in their order.
template <class Enum, std::size_t count>
constexpr bool are_all(const Enum (&enumerators)[count], Enum last) {
  for (std::size_t i = 0; i < count; ++i) {
    if (static_cast<std::size_t>(enumerators[i]) != i) return false;
  }
  return count == static_cast<std::size_t>(last) + 1;
}
static_assert(are_all(kStatuses, Status::internal));
static_assert(are_all(kArguments, Argument::robot_sizes));

// Text i of so many that follow each other, or the one behind them where i is no number of a text. A table of pointers
// would take more flash than the texts.
const char* text(const char* texts, std::size_t i, std::size_t count) {
  for (std::size_t left = i < count ? i : count; left > 0; --left) {
    while (*texts++ != '\0') {
    }
  }
  return texts;
}

}  // namespace

const char* to_string(Status status) {
  return text(kStatusNames, static_cast<std::size_t>(status), std::size(kStatuses));
}

const char* to_string(Argument argument) {
  return text(kArgumentNames, static_cast<std::size_t>(argument), std::size(kArguments));
}

}  // namespace krait
