// SPDX-License-Identifier: Apache-2.0
/// \file
/// The planner: Algorithm 1 of the paper, by which a motion tree grows from the group with the largest weight toward
/// the goal along the shortest path of regions; failures raise edge costs, and the shortest paths are found again.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "krait/goal.hpp"
#include "krait/parameters.hpp"
#include "krait/plan.hpp"
#include "krait/robot.hpp"
#include "krait/scene.hpp"
#include "krait/status.hpp"

namespace krait {

class Planner;
namespace detail {
class AdaptiveSearch;
AdaptiveSearch& opened(Planner& planner);
const AdaptiveSearch& opened(const Planner& planner);
}  // namespace detail

/// What a planner is made from; all of it must outlive the planner and stay where it is.
struct Setup {
  static constexpr std::size_t kAlignment = 8;  ///< bytes, of the block

  void* block = nullptr;         ///< the caller's, aligned to kAlignment; the planner alone writes to it
  std::uint64_t bytes = 0;       ///< length of the block
  const Scene* scene = nullptr;  ///< opened
  Robot robot;                   ///< refers to a robot of any model, which is no temporary
};

/// Sees a search as it goes: refers to what is called, which must outlive it; by default to nothing. A watched step
/// costs one call through a pointer more.
class Watch {
 public:
  Watch() = default;  ///< calls nothing
  /// Calls watch(from, to) with states, and watch.expands(vertex, target) where there is such a member.
  template <class W>
  requires(!std::same_as<std::remove_cvref_t<W>, Watch> && std::invocable<W&, const float*, const float*>)
      Watch(W&& watch)  // NOLINT(google-explicit-constructor,bugprone-forwarding-reference-overload): made by its name
      : self_(&watch), step_(&step<std::remove_reference_t<W>>), expands_(&expands<std::remove_reference_t<W>>) {}

  /// A step that the tree grew by: states of robot.state_size() floats, which last for the call only.
  void operator()(const float* from, const float* to) const {
    if (step_ != nullptr) step_(self_, from, to);
  }
  /// An expansion that begins: from which vertex of the tree, toward what.
  void expands(Index vertex, const Target& target) const {
    if (expands_ != nullptr) expands_(self_, vertex, target);
  }

 private:
  template <class W>
  static void step(const void* self, const float* from, const float* to) {
    (*const_cast<W*>(static_cast<const W*>(self)))(from, to);
  }
  template <class W>
  static void expands(const void* self, [[maybe_unused]] Index vertex, [[maybe_unused]] const Target& target) {
    auto& watch = *const_cast<W*>(static_cast<const W*>(self));
    if constexpr (requires { watch.expands(vertex, target); }) watch.expands(vertex, target);
  }

  const void* self_ = nullptr;
  void (*step_)(const void* self, const float* from, const float* to) = nullptr;
  void (*expands_)(const void* self, Index vertex, const Target& target) = nullptr;
};

/// What a search is to find.
struct Query {
  const float* start = nullptr;  ///< robot.state_size() floats, copied; the position in the scene's local coordinates
  Goal goal = Goal::named(0);    ///< copied
  std::uint64_t seed = 1;        ///< any; the same seed, the same plan
};

/// What a search has done so far, and those that improve made after it, by the names of the plan's JSON.
struct Statistics {
  std::uint64_t iterations = 0;        ///< expansions; of a long one every max_steps steps
  std::uint64_t restarts = 0;          ///< tries after the first (SearchTuning::restart_unit)
  std::uint64_t vertices = 0;          ///< that the motion tree grew by
  std::uint64_t recycled = 0;          ///< of those kept to grow from, given up for want of memory
  std::uint64_t collision_checks = 0;  ///< placements of the whole robot that were tested
  std::uint64_t dijkstra_runs = 0;     ///< shortest paths of all regions found anew
  std::uint64_t regions_repaired = 0;  ///< shortest paths that changed by a repair in place of a run
  std::uint64_t plans_refused = 0;     ///< ways to the goal that did not hold as driven
  std::uint64_t bytes_used = 0;        ///< of the block: tables, and what vertices and expansions took at most
  std::uint64_t bytes_given = 0;       ///< length of the block
  std::uint32_t plan_steps = 0;        ///< controls of the plan, each held for a time step
  float plan_length = 0.0F;            ///< metres
  float plan_duration = 0.0F;          ///< seconds
  float plan_end_speed = 0.0F;         ///< m/s, of the last state; 0 of a robot whose states have no speed
  std::uint64_t hash = 0;              ///< Plan::hash; 0 without a plan
  std::uint64_t improvements = 0;      ///< better plans that improve has found
};

/// Until an init has succeeded, every member that returns a Status returns that of the last init, bad_argument before
/// the first; plan() is empty and statistics() is all zeros. The same holds after an init that fails, except that
/// statistics() keeps the counts of the last search. A planner is neither copied nor moved: a copy would write to the
/// same block.
class Planner {
 public:
  /// Not set up.
  Planner();
  Planner(const Planner&) = delete;             ///< would write to the same block
  Planner& operator=(const Planner&) = delete;  ///< likewise

  /// Bytes of the block that init needs; 0 vertices count as none. The same on every target. No promise for a
  /// robot that init would refuse. O(1).
  static std::uint64_t bytes_required(const Scene& scene, const Robot& robot, const Limits& limits);

  /// The limits that spend a block of `bytes` best: as many vertices and expansions as fit beside `way_legs` legs, at
  /// least 2. No promise for a robot that init would refuse. O(log kMost).
  static Limits limits_for(std::uint64_t bytes, const Scene& scene, const Robot& robot, std::uint32_t way_legs = 0);

  /// Cuts the block up: as many vertices as fit where the limits state none. Copies parameters and limits. Returns ok,
  /// or why not: bad_arithmetic, bad_argument (a scene that was not opened, too), bad_robot, arena_too_small. May be
  /// called again.
  [[nodiscard]] Failure init(const Setup& setup, const Parameters& parameters = {}, const Limits& limits = {});

  /// Begins a search, ending any other. Returns searching; or solved, when a plan may end with the start; or no_route,
  /// goal_in_obstacle, start_outside, start_in_collision, bad_argument; bad_scene, when the scene is found to be
  /// another than at init (Scene::fingerprint); after an init that failed, what that one returned. Work: a Dijkstra,
  /// 2,730 distances.
  [[nodiscard]] Status start(const Query& query);

  /// At most `iterations` expansions more; returns at once when the search has ended. Where an expansion comes so near
  /// to the goal that braking may end there, it brakes, and from every fourth state near a pose it drives the shortest
  /// few of at most 216 lines to it; such steps count as steps of the expansion for the work of a call, and it goes on
  /// where they lead to nothing. A way that has reached the goal is driven once more before it is returned as a plan:
  /// up to max_steps steps of it count as one of `iterations` here, but not in Statistics and Limits. The result does
  /// not depend on how a search is cut into calls.
  [[nodiscard]] Status advance(std::uint64_t iterations);

  /// The same, and calls watch(from, to), states, for every step that the tree grows by; before an expansion
  /// watch.expands(vertex, target), where there is such a member.
  [[nodiscard]] Status advance(std::uint64_t iterations, const Watch& watch);

  /// At most `iterations` more of looking for a plan of fewer steps; plan() and Statistics::plan_steps, plan_length,
  /// plan_duration and hash are then those of the best so far, which was driven and proven as the first one was. Where
  /// the robot is a chain of four bodies or more, most iterations are those of searches that begin anew, in the same
  /// tree; their work is that of an iteration of advance, they count in Statistics and Limits as its do, each begins
  /// with a Dijkstra, and the last of a series ends with one. Work of any other: at most max_steps steps, near a pose
  /// with the choice of lines as in advance at every third at most, and 16 legs' steps that are not proven, or
  /// O(way_legs); the first call after start begins with one Dijkstra. The result does not depend on how the iterations
  /// are cut into calls. Plans and their cursors from before the call end with it. Returns status() and does nothing
  /// where that is not solved or the plan has no steps; bad_argument where Limits::way_legs is 0.
  [[nodiscard]] Status improve(std::uint64_t iterations);

  /// Ends the search as time_used, for a port whose clock says so. No effect once it has ended. O(1).
  void stop_for_time();

  /// Where the search stands: ready before the first start; before init, bad_argument. O(1).
  [[nodiscard]] Status status() const;
  /// The last answer, with its details; the reference stays valid for as long as the planner.
  [[nodiscard]] const Failure& failure() const;

  /// Empty unless solved. Valid until the next start, improve or init. O(legs of the plan).
  Plan plan() const;

  /// What the search that started last has done; before the first all zeros but the block's bytes. O(1).
  Statistics statistics() const;

  /// After start_in_collision: what the robot is too near to at its start; else Hindrance::none. O(pieces near the
  /// robot + bodies^2).
  Contact contact();

  /// The widest way of a search that ended without a plan, after no_route too narrow for the robot; all zero elsewhere.
  /// Work: at most two Dijkstras for the widest way, two for the costs, and 4,095 distances of a point.
  Bottleneck bottleneck();

  /// Where a search that has started has made most of its expansions, the first among equals. O(R).
  Effort effort() const;

  /// The least cost h of the regions that a search has reached since it last began anew, metres; infinite where it has
  /// not started. O(R).
  float cost_to_go() const;

 private:
  friend detail::AdaptiveSearch& detail::opened(Planner& planner);
  friend const detail::AdaptiveSearch& detail::opened(const Planner& planner);

  // The size of a detail::AdaptiveSearch, whose arrays are all in the block.
  static constexpr std::size_t kSearchBytes = sizeof(void*) == 8 ? 6088 : 5488;

  alignas(std::uint64_t) std::byte search_[kSearchBytes];
};

}  // namespace krait
