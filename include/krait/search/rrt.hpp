// SPDX-License-Identifier: Apache-2.0
// RRT, the other planner that the paper compares with: [14] S. LaValle, J. Kuffner, Randomized Kinodynamic Planning,
// IJRR 2001, in the version that connects: from the vertex nearest to a random point the tree grows until the point is
// reached or a step collides.
#pragma once

#include "krait/search/nearest.hpp"
#include "krait/search/search.hpp"

namespace krait {

class RrtPlanner : public Search<RrtPlanner, NearestPoints> {
  using Base = Search<RrtPlanner, NearestPoints>;
  using Expansion = Base::Expansion;
  friend Base;

  // The regions tell whether there is a route at all, and guide nothing.
  static std::uint32_t restart_unit() { return 0; }
  static std::uint32_t doomed_steps() { return 0; }
  static std::uint32_t open_steps() { return 0; }
  static float slowest() { return kRivalsSlowest; }
  static float end_speed() { return kInfinity; }
  static bool shoots() { return false; }

  void reset_guide() {
    guide_.clear();
    connecting_ = kNone;
  }

  // Every state becomes a vertex.
  bool keep(Index, Branch branch, const float* state) {
    if (tree_.vertices_full()) return false;
    newest_ = tree_.add(branch, state);
    guide_.insert(position(newest_));
    return true;
  }

  // A connection longer than one expansion goes on in the next iteration. It also searches the nearest vertex,
  // O(vertices) at worst.
  void iterate(const Watch& watch) {
    if (tree_.expansions_full()) {
      finish(Status::tree_full);
      return;
    }
    if (connecting_ == kNone) begin_connection();
    const Vec2 from = position(connecting_);
    const auto expanded = expand(connecting_, kNone, target_, watch);
    const bool goes_on = expanded.result == Expansion::target_not_reached && comes_closer(from);
    connecting_ = goes_on ? newest_ : kNone;
  }

  void begin_connection() {
    const bool to_goal = random_.unit() < parameters_.rrt.goal_share;
    const Vec2 point = to_goal ? regions_.random_goal_point(random_) : random_point_in_bounds();
    target_ = any_way_to(point, Base::kPatience);
    connecting_ = guide_.nearest(point);
  }

  // Whether an expansion was not in vain: a robot may circle its target for ever.
  bool comes_closer(Vec2 from) const {
    return length(target_.point - position(newest_)) < length(target_.point - from);
  }

  Target target_;
  Index connecting_ = kNone;  // the vertex that a connection goes on from, or none
  Index newest_ = kNone;
};

// Compiled once, in the library.
extern template class Search<RrtPlanner, NearestPoints>;

}  // namespace krait
