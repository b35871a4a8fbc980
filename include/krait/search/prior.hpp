// SPDX-License-Identifier: Apache-2.0
// The planner of prior work that the paper compares with: [18] E. Plaku, Robot Motion Planning with Dynamics as Hybrid
// Search, AAAI 2013. Tree, groups and shortest paths are Algorithm 1's, but edge costs never change.
#pragma once

#include "krait/search/grouped.hpp"

namespace krait {

// A group's weight is (epsilon + (1 - epsilon) (h_max - h) / (h_max - h_min))^alpha beta^selections. h_min is the
// goal's 0, and 1 - epsilon is 1 in float: Eqn 7 with another epsilon.
class PriorPlanner : public GroupedSearch<PriorPlanner, Groups> {
  using Base = GroupedSearch<PriorPlanner, Groups>;
  template <class, class>
  friend class Search;

  static constexpr int kMaxTries = 16;  // at a point outside obstacles

  static std::uint32_t restart_unit() { return 0; }
  static std::uint32_t doomed_steps() { return 0; }
  static std::uint32_t open_steps() { return 0; }
  static float slowest() { return kRivalsSlowest; }
  static float end_speed() { return kInfinity; }
  static bool shoots() { return false; }

  void reset_guide() {
    guide_.clear({parameters_.alpha, parameters_.beta, parameters_.prior.epsilon}, kUnboundedSample);
  }

  // An expansion also looks at every vertex of its group.
  void iterate(const Watch& watch) {
    if (!room_for_expansion()) return;
    const Index group = guide_.select(regions_);
    const Vec2 point = choose_point(group);
    const Index vertex = choose_vertex(group, point);
    expand(vertex, group, any_way_to(point, guide_.selections(group)), watch);
  }

  // Where to steer: mostly into a region ahead, at times to the goal or anywhere.
  Vec2 choose_point(Index group) {
    const PriorParameters& prior = parameters_.prior;
    const float choice = random_.unit();
    if (choice < prior.path_share) {
      return regions_.random_point(regions_.random_ahead(group, prior.path_regions, random_), random_);
    }
    if (choice < prior.path_share + prior.goal_share) return regions_.random_goal_point(random_);
    return random_free_point();
  }

  // Uniform over the triangles' union, by rejection from the bounds; the last try in an obstacle stands.
  Vec2 random_free_point() {
    Vec2 point = random_point_in_bounds();
    for (int tries = 1; tries < kMaxTries && locate(*scene_, point) == kNone; ++tries) {
      point = random_point_in_bounds();
    }
    return point;
  }

  Index choose_vertex(Index group, Vec2 point) {
    const bool nearest = random_.unit() < parameters_.prior.nearest_share;
    return nearest ? nearest_vertex(group, point) : guide_.random_vertex(group, random_);
  }

  // By position; the smallest number among equals.
  Index nearest_vertex(Index group, Vec2 point) const {
    Index best = kNone;
    float least = kInfinity;
    guide_.for_each_vertex(group, [&](Index vertex) {
      const Vec2 apart = point - position(vertex);
      const float squared = dot(apart, apart);
      if (squared > least || (squared == least && vertex > best)) return;
      least = squared;
      best = vertex;
    });
    return best;
  }
};

// Compiled once, in the library.
extern template class Search<PriorPlanner, Groups>;
extern template class GroupedSearch<PriorPlanner, Groups>;

}  // namespace krait
