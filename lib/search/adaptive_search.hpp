// SPDX-License-Identifier: Apache-2.0
// Algorithm 1: the motion tree grows from the group with the largest weight toward the goal along the shortest path of
// regions; failures raise edge costs, and the shortest paths are found again.
#pragma once

#include "search/departure.hpp"
#include "search/grouped.hpp"
#include "search/sketcher.hpp"

namespace krait::detail {

// The implementation of Planner, which holds one.
class AdaptiveSearch : public GroupedSearch {
 public:
  // These do what the members of Planner do (krait/planner.hpp).
  static std::uint64_t bytes_required(const Scene& scene, const Robot& robot, const Limits& limits);
  static Limits limits_for(std::uint64_t bytes, const Scene& scene, const Robot& robot, std::uint32_t way_legs = 0);
  Failure init(const Setup& setup, const Parameters& parameters = {}, const Limits& limits = {});
  Status start(const Query& query);
  Status advance(std::uint64_t iterations) { return advance(iterations, Watch()); }
  Status advance(std::uint64_t iterations, const Watch& watch);
  Status improve(std::uint64_t iterations);

 private:
  // Measured: bench/ABLATIONS.md, "Constants".
  static constexpr float kSketchTime = 2.0F;   // of a sketched step, in time steps, at most
  static constexpr float kSketchRate = 0.65F;  // a sketched step times the robot's fastest rate, at most
  static constexpr float kSightRoom = 1.05F;   // of a line of sight, in radii of the bodies' discs
  static constexpr float kSightStep = 0.4F;    // of looks along it, in lengths of body 0

  // Empties the groups, and ends a long expansion.
  void reset_groups();

  // The length of a sketched step, seconds.
  float sketched_step() const;

  // An iteration of a restarted search, for a better plan.
  void iterate_restarted();

  // Algorithm 1, lines 4 to 13.
  void iterate(const Watch& watch);

  void begin_expansion(const Watch& watch);

  // Makes the iteration one of the robot's departure from a narrow place, if it is time for that.
  bool departs(const Watch& watch);

  // Whether the costs are to be recomputed after this expansion: after every kappa, but after an update that looked at
  // n regions not before n / update_regions expansions.
  bool update_due() const;

  // Updates weights and costs after an expansion. A long one that reaches its target does not count as a selection of
  // its group.
  void learn_from(const Expanded& expanded);

  // An expansion may go from the vertex toward the target.
  struct Way {
    Index vertex;
    Target target;
    float cost;             // h of the target's region; infinite for a stray
    bool promising = true;  // whether it is worth driving
  };

  // Draws some ways and returns the first whose sketch is free to the end; else the one whose sketch is free the
  // longest. Those whose targets are the nearest to the goal are looked at first, but the first of all if it strays.
  Way choose_way(Index group);

  // Algorithm 2, lines 2 and 3: a member of the group, a region among the first `ahead` of the shortest path after the
  // group's, a point in it, one in sight if some tries find it; now and then any point of the workspace, which ends
  // long series of failures at one place.
  Way any_way(Index group, Index ahead);

  // Writes h of the point's region to `cost`.
  Vec2 point_ahead(Index group, Index ahead, Vec2 from, float& cost);

  // Algorithm 1, lines 9 to 11.
  void raise_costs(Index last_region);

  // Algorithm 1, line 12.
  void update_costs();

  Sketcher sketcher_;
  Sight sight_;
  std::uint32_t updates_wait_;  // iterations in which the costs stay
  bool goes_on_;                // whether the last expansion is a long one that has not ended
  Index group_;                 // that it grows from
  Way ways_[SearchTuning::kMostCandidates];
  Departure departure_;
};

}  // namespace krait::detail
