// SPDX-License-Identifier: Apache-2.0
// Algorithm 1: the motion tree grows from the group with the largest weight toward the goal along the shortest path of
// regions; failures raise edge costs, and the shortest paths are found again.
#pragma once

#include "krait/search/grouped.hpp"
#include "krait/search/sketcher.hpp"

namespace krait {

class Planner : public GroupedSearch<Planner> {
  using Base = GroupedSearch<Planner>;
  using Expansion = typename Base::Expansion;
  template <class, class>
  friend class Search;

  static constexpr float kSketchTime = 2.0F;   // of a sketched step, in time steps, at most
  static constexpr float kSketchRate = 0.65F;  // a sketched step times the robot's fastest rate, at most
  static constexpr float kSightRoom = 1.6F;    // of a line of sight, in radii of the bodies' discs
  static constexpr float kSightStep = 0.4F;    // of looks along it, in lengths of body 0

  void reset_guide() {
    const Parameters& parameters = this->parameters_;
    this->guide_.clear({parameters.alpha, parameters.beta, parameters.epsilon}, parameters.group_sample);
    raised_ = false;
    goes_on_ = false;
    sketcher_.assign(this->robot_, *this->scene_, sketched_step(), parameters.near_radius * this->robot_length_);
    sight_ = Sight(*this->scene_, kSightRoom * sketcher_.radius(), kSightStep * this->robot_length_);
  }
  // Seconds.
  float sketched_step() const {
    const float step = kSketchTime * this->parameters_.dt;
    const float longest = longest_step(this->robot_, this->parameters_.dt, kSketchRate);
    return step < longest ? step : longest;
  }
  std::uint32_t restart_unit() const { return this->parameters_.restart_unit; }
  std::uint32_t doomed_steps() const { return this->parameters_.doomed_steps; }
  std::uint32_t open_steps() const { return this->parameters_.open_steps; }
  float slowest() const { return this->parameters_.slowest; }
  float end_speed() const { return this->parameters_.end_speed; }
  static bool shoots() { return true; }

  // Algorithm 1, lines 4 to 13.
  void iterate(const Watch& watch) {
    if (goes_on_) {
      heed(this->go_on(watch));
    } else {
      begin_expansion(watch);
    }
    if (this->status() != Status::searching) return;
    if (this->statistics_.iterations % update_interval() == 0) update_costs();
  }

  void begin_expansion(const Watch& watch) {
    if (!this->room_for_expansion()) return;
    if (this->parameters_.plain) this->guide_.weigh(this->regions_);
    group_ = this->guide_.select(this->regions_);
    const Way way = choose_way(group_);
    if (way.promising) {
      heed(this->expand(way.vertex, group_, way.target, watch));
    } else {
      raise_costs(group_);
    }
  }

  // Expansions between updates: the work of an update, O(R log R), is shared by at least R / update_regions of them.
  std::uint32_t update_interval() const {
    const Parameters& parameters = this->parameters_;
    if (parameters.update_regions == 0) return parameters.kappa;
    const std::uint32_t least = this->scene_->triangle_count() / parameters.update_regions;
    return least > parameters.kappa ? least : parameters.kappa;
  }

  // What is learnt from an expansion. A long one that reaches its target does not count as a selection of its group.
  template <class Expanded>
  void heed(const Expanded& expanded) {
    goes_on_ = expanded.result == Expansion::goes_on;
    const bool long_way = expanded.last.step > this->parameters_.max_steps;
    if (long_way && expanded.result == Expansion::target_reached) this->guide_.unselect(this->regions_, group_);
    if (expanded.result == Expansion::collision) raise_costs(expanded.region);
  }

  // From where to where an expansion may go.
  struct Way {
    Index vertex;
    Target target;
    float cost;             // h of the target's region; infinite for a stray
    bool promising = true;  // whether it is worth driving
  };

  // Of some ways the first whose sketch is free to the end; else the one whose sketch is free the longest. Those whose
  // targets are the nearest to the goal are looked at first, but the first of all if it strays.
  Way choose_way(Index group) {
    const std::uint32_t count = this->parameters_.candidates;
    if (count == 0) return any_way(group);
    for (std::uint32_t i = 0; i < count; ++i) {
      Way way = any_way(group);
      if (i == 0 && way.cost == kInfinity) way.cost = -1.0F;
      std::uint32_t at = i;
      for (; at > 0 && ways_[at - 1].cost > way.cost; --at) ways_[at] = ways_[at - 1];
      ways_[at] = way;
    }
    std::uint32_t best = 0;
    std::uint32_t longest = 0;
    for (std::uint32_t i = 0; i < count && longest < Sketcher::kSteps; ++i) {
      const std::uint32_t steps = sketcher_.free_steps(this->tree_.state(ways_[i].vertex), ways_[i].target);
      if (steps <= longest) continue;
      longest = steps;
      best = i;
    }
    ways_[best].promising = longest >= this->parameters_.least_sketch;
    return ways_[best];
  }

  // Algorithm 2, lines 2 and 3: a member of the group, a region among the first of the shortest path after the group's,
  // a point in it, one in sight if some tries find it; now and then any point of the workspace, which ends long series
  // of failures at one place.
  Way any_way(Index group) {
    Way way;
    way.vertex = this->guide_.random_vertex(group, this->random_);
    const float stray = this->parameters_.stray_share;
    const bool strays = stray > 0.0F && this->random_.unit() < stray;
    way.cost = kInfinity;
    const Vec2 point =
        strays ? this->random_point_in_bounds() : point_ahead(group, this->position(way.vertex), way.cost);
    way.target = this->any_way_to(point, this->guide_.selections(group));
    if (way.cost == 0.0F) this->slow_for(way.target, way.vertex);
    return way;
  }

  // Writes h of the point's region to `cost`.
  Vec2 point_ahead(Index group, Vec2 from, float& cost) {
    const Regions& regions = this->regions_;
    for (std::uint32_t tries = 1;; ++tries) {
      const Index region = regions.random_ahead(group, this->parameters_.path_regions, this->random_);
      const Vec2 point = regions.random_point(region, this->random_);
      cost = regions.cost(region);
      if (tries >= this->parameters_.sight_tries || sight_.line_free(from, point)) return point;
    }
  }

  // Algorithm 1, lines 9 to 11.
  void raise_costs(Index last_region) {
    const Index next = this->regions_.next(last_region);
    if (next == kNone || (this->regions_.is_goal(next) && !this->parameters_.raise_goal)) return;
    this->regions_.raise_edges(next, {this->parameters_.gamma, this->parameters_.cost_length * this->robot_length_});
    raised_ = true;
  }

  // Algorithm 1, line 12.
  void update_costs() {
    if (!raised_) return;
    raised_ = false;
    if (this->parameters_.plain) {
      this->regions_.update();
      ++this->statistics_.dijkstra_runs;
    } else {
      this->statistics_.regions_repaired += this->regions_.repair();
    }
    this->guide_.weigh(this->regions_);
  }

  bool raised_ = false;
  bool goes_on_ = false;  // whether the last expansion is a long one that has not ended
  Index group_ = kNone;   // that it grows from
  Sight sight_;
  Sketcher sketcher_;
  Way ways_[Parameters::kMostCandidates];
};

// Compiled once, in the library.
extern template class Search<Planner, Groups>;
extern template class GroupedSearch<Planner>;

}  // namespace krait
