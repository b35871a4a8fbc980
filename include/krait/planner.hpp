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
class Watch;
namespace detail {
class AdaptiveSearch;
AdaptiveSearch& opened(Planner& planner);
const AdaptiveSearch& opened(const Planner& planner);

// What a Watch can call: any but a Watch itself.
template <class W>
concept Watches = !std::same_as<std::remove_cvref_t<W>, Watch> && std::invocable<W&, const float*, const float*>;
}  // namespace detail

/// The arguments of Planner::init, copied. What they refer to (block, scene with its bytes, and robot) must outlive the
/// planner and stay where it is.
struct Setup {
  static constexpr std::size_t kAlignment = 8;  ///< bytes, of the block

  void* block = nullptr;         ///< the caller's, aligned to kAlignment; the planner alone writes to it
  std::uint64_t bytes = 0;       ///< length of the block
  const Scene* scene = nullptr;  ///< opened
  Robot robot;                   ///< refers to a robot of any model, which is no temporary
};

/// Observes a search. Holds a reference to a callable, which must outlive it, or to none. Each observed step costs one
/// indirect call.
class Watch {
 public:
  Watch() = default;  ///< refers to no callable
  /// Calls watch(from, to) with states, and watch.expands(vertex, target) where there is such a member.
  template <detail::Watches W>
  Watch(W& watch)  // NOLINT(google-explicit-constructor): made by its name
      : self_(&watch), step_(&step<W>), expands_(&expands<W>) {}
  template <detail::Watches W>
  Watch(const W&&) = delete;  ///< would not outlive this

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

/// A planning problem.
struct Query {
  const float* start = nullptr;  ///< robot.state_size() finite floats within the robot's limits, in the units of its
                                 ///< state, copied; the position in the scene's local metres
  Goal goal = Goal::named(0);    ///< copied; start refuses one that is not Goal::valid
  std::uint64_t seed = 1;        ///< any; the same seed, the same plan
};

/// What a search and the calls of improve after it have done so far. The plan's JSON has the same names, with the unit
/// behind those of the plan's length, duration and end speed.
struct Statistics {
  std::uint64_t iterations = 0;        ///< expansions; each max_steps steps of a long one count as one
  std::uint64_t restarts = 0;          ///< tries after the first (SearchTuning::restart_unit)
  std::uint64_t vertices = 0;          ///< states that were added to the motion tree, with the start
  std::uint64_t recycled = 0;          ///< states that were kept to grow from and dropped for lack of memory
  std::uint64_t collision_checks = 0;  ///< placements of the whole robot that were tested
  std::uint64_t dijkstra_runs = 0;     ///< computations of the shortest paths of all regions
  std::uint64_t regions_repaired = 0;  ///< single shortest paths that were recomputed after costs had risen
  std::uint64_t plans_refused = 0;     ///< ways to the goal that failed the proof when they were driven once more
  std::uint64_t bytes_used = 0;        ///< bytes of the block for tables, and the most for vertices and expansions
  std::uint64_t bytes_given = 0;       ///< length of the block
  std::uint32_t plan_steps = 0;        ///< controls of the plan, each held for a time step
  float plan_length = 0.0F;            ///< metres
  float plan_duration = 0.0F;          ///< seconds
  float plan_end_speed = 0.0F;         ///< m/s, of the last state; 0 of a robot whose states have no speed
  std::uint64_t hash = 0;              ///< Plan::hash; 0 without a plan
  std::uint64_t improvements = 0;      ///< better plans found by improve
};

/// Plans for one robot in one scene, in the caller's block.
///
/// Before the first init, every member that returns a Status returns bad_argument; after an init that failed, it
/// returns the Status of that init. In both cases plan() is empty and statistics() all zeros. A planner is neither
/// copied nor moved: a copy would write to the same block. Several threads may each use a planner with a block of its
/// own, also for the same scene and robot; one planner is used by one thread at a time. Below, R is the number of the
/// scene's triangles.
class Planner {
 public:
  /// A planner without a block: call init before all else. O(1). init does all that this does, so that a static planner
  /// may be used where start-up code runs no constructors, but not before init.
  Planner();
  Planner(const Planner&) = delete;             ///< would write to the same block
  Planner& operator=(const Planner&) = delete;  ///< would write to the same block

  /// The bytes of the block that init needs, the same on every target. Limits::vertices 0 is counted as no vertices at
  /// all, so state a number. Unspecified for a robot or limits that init would refuse. O(1).
  static std::uint64_t bytes_required(const Scene& scene, const Robot& robot, const Limits& limits);

  /// The limits that use a block of `bytes` fully: as many vertices and expansions as fit beside `way_legs` legs, at
  /// least 2 vertices, even where those do not fit. Unspecified for a robot that init would refuse. Work: 22 times that
  /// of bytes_required.
  static Limits limits_for(std::uint64_t bytes, const Scene& scene, const Robot& robot, std::uint32_t way_legs = 0);

  /// Divides the block into its arrays; with Limits::vertices 0, allocates as many vertices as fit. Copies parameters
  /// and limits. Returns ok; or bad_arithmetic; bad_argument for the block, a scene that was not opened, a parameter or
  /// a limit; bad_robot; or arena_too_small. May be called again, which ends every search and plan. Work: looks at
  /// every vertex of the bodies, calls the robot's fastest_rate at most 26 times, reads at most 310 words of the scene
  /// (Scene::fingerprint), and evaluates bytes_required once, or with Limits::vertices 0 23 times.
  Failure init(const Setup& setup, const Parameters& parameters = {}, const Limits& limits = {});

  /// Begins a search, ending any other. Returns searching; or solved, when a plan may end with the start; or no_route,
  /// goal_in_obstacle, start_outside, start_in_collision, bad_argument; bad_scene, when the scene is found to be
  /// another than at init (Scene::fingerprint); after an init that failed, what that one returned. Work: one Dijkstra
  /// over the regions, O(R log R); at most 2,730 distances of a point from the obstacles; one collision check; and at
  /// most 310 words of the scene.
  Status start(const Query& query);

  /// Runs at most `iterations` more expansions, each of at most max_steps steps; returns at once when the search has
  /// ended. Returns searching where it goes on, or how it has ended: solved, budget_used, tree_full (WhenFull),
  /// internal, or what start returned. Steps that brake or drive the last metres to a pose count as steps of their
  /// expansion, which continues from where they began if they do not end in the goal. A way that reached the goal is
  /// driven once more before it becomes the plan: each max_steps steps of that use up one of `iterations`, but do not
  /// count in Statistics and Limits. The result does not depend on how a search is split into calls.
  ///
  /// Work per iteration, at most; `krait info` prints these bounds for a scene and a robot:
  /// - max_steps steps, each with its collision check and Goal::contains;
  /// - the lines of sight and the sketches that SearchTuning::sight_tries and candidates allow;
  /// - one Dijkstra, O(R log R).
  ///
  /// And, where the query causes it:
  /// - when the memory is full: O(R) for each step and for each group whose states are dropped;
  /// - near a pose, at every fourth state: 288 lines to the pose, with 128 looks at a disc each. Where none of these
  ///   lines ends in the goal, a robot that pushes trailers (kDocks) tries 288 more, and one that parks (kParks) 576;
  /// - for a robot that parks, 147,456 placements of body 0 to find the ways out of the pose: once a query, and again
  ///   after each search for ways out of the start;
  /// - for a robot that parks and has not come away from its start, 73,728 placements before each way out that it
  ///   drives (SearchTuning::stuck_expansions).
  Status advance(std::uint64_t iterations);

  /// The same, and calls watch(from, to) with the two states of every step that the tree grows by. Where watch has a
  /// member `expands`, it also calls watch.expands(vertex, target) before each expansion toward a point, but not before
  /// the legs that brake, that lead to a pose, or that lead out of a narrow place. Costs one indirect call more for
  /// each of these.
  Status advance(std::uint64_t iterations, const Watch& watch);
  /// The same with a watch that has no name, such as a lambda: it is called during the call only.
  template <detail::Watches W>
  Status advance(std::uint64_t iterations, W&& watch) {
    return advance(iterations, Watch(watch));
  }

  /// Runs at most `iterations` iterations that look for a plan with fewer steps. plan() and the plan's figures in
  /// Statistics are then those of the best plan so far, proven like the first. Invalidates earlier plans and cursors.
  /// Returns status(), and does nothing, unless that is solved and the plan has steps; else bad_argument where
  /// Limits::way_legs is 0, while status() and failure() stay as they are. The result does not depend on how iterations
  /// are split into calls.
  ///
  /// An iteration either drives along a line or belongs to a search that starts again with an empty tree. Such searches
  /// take most iterations for a chain of four or more bodies. They do so for any other robot, too, until a line that is
  /// driven forwards from the start has led to a better plan. Their iterations count in Statistics and Limits as those
  /// of advance do.
  ///
  /// Work per iteration of such a search: that of advance. Work of any other iteration: at most max_steps steps along a
  /// line, a choice of lines to a pose, as in advance, after at most every third step, and the unproven steps of 16
  /// legs or of 16 of the first plan's expansions; or O(way_legs). One Dijkstra more in the first call after start, at
  /// the begin of each search, and at the end of the last search of a series.
  Status improve(std::uint64_t iterations);

  /// Ends the search as time_used, for a port whose clock says so. No effect once it has ended. O(1).
  void stop_for_time();

  /// Where the search stands: ready before the first start; before init, bad_argument. O(1).
  Status status() const;
  /// The last status with its details. The reference is valid for as long as the planner, and later calls change what
  /// it refers to. O(1).
  [[nodiscard]] const Failure& failure() const;

  /// Empty unless solved. Valid until the next start, improve or init. O(legs of the plan).
  Plan plan() const;

  /// What the search that started last has done; before the first start all zeros but the bytes of the block. O(1).
  Statistics statistics() const;

  /// After start_in_collision: what the robot is too near to at its start; else ContactKind::none. O(pieces near the
  /// robot + bodies^2).
  Contact contact();

  /// The widest way from the start to the goal, after a search that ended without a plan; all zeros after every other
  /// status. After no_route this way is too narrow for the robot. Work: at most four Dijkstras, O(R log R), and 2,730
  /// distances of a point.
  Bottleneck bottleneck();

  /// The region from which a search has made most expansions since its last restart, the first of equal ones; zero
  /// before the first start. O(R).
  Effort effort() const;

  /// Metres: the least cost h (SearchTuning) among the regions that a search has reached since its last restart;
  /// infinite before the first start. O(R).
  float cost_to_go() const;

 private:
  friend detail::AdaptiveSearch& detail::opened(Planner& planner);
  friend const detail::AdaptiveSearch& detail::opened(const Planner& planner);

  // The size of a detail::AdaptiveSearch, whose arrays are all in the block.
  static constexpr std::size_t kSearchBytes = sizeof(void*) == 8 ? 6216 : 5608;

  alignas(std::uint64_t) std::byte search_[kSearchBytes];
};

}  // namespace krait
