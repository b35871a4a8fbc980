// SPDX-License-Identifier: Apache-2.0
// RRT, the other planner that the paper compares with: [14] S. LaValle, J. Kuffner, Randomized Kinodynamic Planning,
// IJRR 2001, in the version that connects: from the vertex nearest to a random point the tree grows until the point is
// reached or a step collides.
#pragma once

#include "host/rivals/nearest.hpp"
#include "host/rivals/rival.hpp"
#include "search/search.hpp"

namespace krait::rivals {

struct RrtParameters {
  float goal_share = 0.05F;  // 0 … 1: share of targets in the goal; the rest is uniform over the bounds
};

// Used as krait::Planner is. The regions tell whether there is a route at all, and guide nothing.
class RrtPlanner : public Search {
 public:
  explicit RrtPlanner(const RrtParameters& rrt = {}) : rrt_(rrt) { shoots_at_poses_ = false; }

  static std::uint64_t bytes_required(const Scene& scene, const Robot& robot, const Limits& limits);

  Failure init(const Setup& setup, const Parameters& parameters = {}, const Limits& limits = {});
  Status start(const Query& query);
  // A connection longer than one expansion goes on in the next iteration. It also searches the nearest vertex,
  // O(vertices) at worst.
  Status advance(std::uint64_t iterations, const Watch& watch = Watch());

 private:
  friend class krait::detail::Keeper;

  // Every state becomes a vertex.
  bool keep(Index region, Branch branch, const float* state);

  void iterate(const Watch& watch);

  void begin_connection();

  // Whether an expansion was not in vain: a robot may circle its target for ever.
  bool comes_closer(Vec2 from) const {
    return length(target_.point - position(newest_)) < length(target_.point - from);
  }

  RrtParameters rrt_;
  NearestPoints points_;  // of the vertices
  Target target_;
  Index connecting_ = kNone;  // the vertex that a connection goes on from, or none
  Index newest_ = kNone;
};

}  // namespace krait::rivals
