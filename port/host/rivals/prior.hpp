// SPDX-License-Identifier: Apache-2.0
// The planner of prior work that the paper compares with: [18] E. Plaku, Robot Motion Planning with Dynamics as Hybrid
// Search, AAAI 2013. Tree, groups and shortest paths are Algorithm 1's, but edge costs never change.
#pragma once

#include "host/rivals/rival.hpp"
#include "search/grouped.hpp"

namespace krait::rivals {

struct PriorParameters {
  float epsilon = 1e-11F;           // 1e-30 … 1: keeps every weight positive
  std::uint32_t path_regions = 10;  // 1 … 64: as SearchTuning::path_regions
  float path_share = 0.85F;         // 0 … 1: share of targets in the regions ahead
  float goal_share = 0.05F;         // 0 … 1 - path_share: in the goal; the rest is uniform over the free workspace
  float nearest_share = 0.9F;       // 0 … 1: how often the group's vertex nearest to the target grows, not any
};

// Used as krait::Planner is. A group's weight is (epsilon + (1 - epsilon) (h_max - h) / (h_max - h_min))^alpha
// beta^selections. h_min is the goal's 0, and 1 - epsilon is 1 in float: Eqn 7 with another epsilon.
class PriorPlanner : public GroupedSearch {
 public:
  explicit PriorPlanner(const PriorParameters& prior = {}) : prior_(prior) { shoots_at_poses_ = false; }

  static std::uint64_t bytes_required(const Scene& scene, const Robot& robot, const Limits& limits);

  Failure init(const Setup& setup, const Parameters& parameters = {}, const Limits& limits = {});
  Status start(const Query& query);
  // An expansion also looks at every vertex of its group.
  Status advance(std::uint64_t iterations, const Watch& watch = Watch());

 private:
  static constexpr int kMaxTries = 16;  // at a point outside obstacles

  void iterate(const Watch& watch);

  // Where to steer: mostly into a region ahead, at times to the goal or anywhere.
  Vec2 choose_point(Index group);

  // Uniform over the triangles' union, by rejection from the bounds; the last try in an obstacle stands.
  Vec2 random_free_point();

  Index choose_vertex(Index group, Vec2 point);

  // By position; the smallest number among equals.
  Index nearest_vertex(Index group, Vec2 point) const;

  PriorParameters prior_;
};

}  // namespace krait::rivals
