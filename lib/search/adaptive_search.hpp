// SPDX-License-Identifier: Apache-2.0
// Algorithm 1: the motion tree grows from the group with the largest weight toward the goal along the shortest path of
// regions; failures raise edge costs, and the shortest paths are found again.
#pragma once

#include "search/grouped.hpp"
#include "search/sketcher.hpp"

namespace krait::detail {

class AdaptiveSearch : public GroupedSearch {
 public:
  // Bytes of the block that init needs. The same on every target. O(1).
  static std::uint64_t bytes_required(const Scene& scene, const Robot& robot, const Limits& limits);

  // The limits that spend a block of `bytes` best: as many vertices and expansions as fit beside `way_legs` legs, at
  // least 2. O(1).
  static Limits limits_for(std::uint64_t bytes, const Scene& scene, const Robot& robot, std::uint32_t way_legs = 0);

  // Cuts the block up: as many vertices as fit where the limits state none. Copies parameters and limits. Returns ok,
  // or why not: bad_arithmetic, bad_argument (a scene that was not opened, too), bad_robot, arena_too_small. May be
  // called again.
  [[nodiscard]] Failure init(const Setup& setup, const Parameters& parameters = {}, const Limits& limits = {});

  // Begins a search, ending any other. Returns searching; or solved, when a plan may end with the start; or no_route,
  // goal_in_obstacle, start_outside, start_in_collision, bad_argument; bad_scene, when the scene is found to be another
  // than at init (Scene::fingerprint); after an init that failed, what that one returned. Work: a Dijkstra, 2,730
  // distances.
  [[nodiscard]] Status start(const Query& query);

  // At most `iterations` expansions more; returns at once when the search has ended. Where an expansion comes so near
  // to the goal that braking may end there, it brakes, and from every fourth state near a pose it drives the shortest
  // few of at most 216 lines to it (last_metres.hpp); such steps count as steps of the expansion for the work of a
  // call, and it goes on where they lead to nothing. A way that has reached the goal is driven once more before it is
  // returned as a plan: up to max_steps steps of it count as one of `iterations` here, but not in Statistics and
  // Limits. The result does not depend on how a search is cut into calls.
  [[nodiscard]] Status advance(std::uint64_t iterations) { return advance(iterations, Watch()); }

  // The same, and calls watch(from, to), states, for every step that the tree grows by; before an expansion
  // watch.expands(vertex, target), where there is such a member.
  [[nodiscard]] Status advance(std::uint64_t iterations, const Watch& watch);

 private:
  static constexpr float kSketchTime = 2.0F;   // of a sketched step, in time steps, at most
  static constexpr float kSketchRate = 0.65F;  // a sketched step times the robot's fastest rate, at most
  static constexpr float kSightRoom = 1.6F;    // of a line of sight, in radii of the bodies' discs
  static constexpr float kSightStep = 0.4F;    // of looks along it, in lengths of body 0

  // No groups, and no long expansion.
  void forget();

  // Of a sketched step, seconds.
  float sketched_step() const;

  // Algorithm 1, lines 4 to 13.
  void iterate(const Watch& watch);

  void begin_expansion(const Watch& watch);

  // Expansions between updates: the work of an update, O(R log R), is shared by at least R / update_regions of them.
  std::uint32_t update_interval() const;

  // What is learnt from an expansion. A long one that reaches its target does not count as a selection of its group.
  void heed(const Expanded& expanded);

  // From where to where an expansion may go.
  struct Way {
    Index vertex;
    Target target;
    float cost;             // h of the target's region; infinite for a stray
    bool promising = true;  // whether it is worth driving
  };

  // Of some ways the first whose sketch is free to the end; else the one whose sketch is free the longest. Those whose
  // targets are the nearest to the goal are looked at first, but the first of all if it strays.
  Way choose_way(Index group);

  // Algorithm 2, lines 2 and 3: a member of the group, a region among the first of the shortest path after the group's,
  // a point in it, one in sight if some tries find it; now and then any point of the workspace, which ends long series
  // of failures at one place.
  Way any_way(Index group);

  // Writes h of the point's region to `cost`.
  Vec2 point_ahead(Index group, Vec2 from, float& cost);

  // Algorithm 1, lines 9 to 11.
  void raise_costs(Index last_region);

  // Algorithm 1, line 12.
  void update_costs();

  Sketcher sketcher_;
  Sight sight_;
  bool raised_ = false;
  bool goes_on_ = false;  // whether the last expansion is a long one that has not ended
  Index group_ = kNone;   // that it grows from
  Way ways_[SearchTuning::kMostCandidates];
};

}  // namespace krait::detail
