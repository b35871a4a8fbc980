// Algorithm 1: the motion tree grows from the group with the largest weight toward the goal along the shortest path of
// regions; failures raise edge costs, and the shortest paths are found again.
#pragma once

#include "krait/search/grouped.hpp"

namespace krait {

template <Robot R>
class Planner : public GroupedSearch<Planner<R>, R> {
  using Base = GroupedSearch<Planner<R>, R>;
  using Expansion = typename Base::Expansion;
  template <class, Robot, class>
  friend class Search;

  void reset_guide() {
    const Parameters& parameters = this->parameters_;
    this->guide_.clear({parameters.alpha, parameters.beta, parameters.epsilon}, parameters.group_sample);
    raised_ = false;
  }
  std::uint32_t restart_unit() const { return this->parameters_.restart_unit; }
  std::uint32_t doomed_steps() const { return this->parameters_.doomed_steps; }
  std::uint32_t open_steps() const { return this->parameters_.open_steps; }

  // Algorithm 1, lines 4 to 13.
  template <class Watch>
  void iterate(Watch watch) {
    if (!this->room_for_expansion()) return;
    if (this->parameters_.plain) this->guide_.weigh(this->regions_);
    const Index group = this->guide_.select(this->regions_);
    const Index vertex = this->guide_.random_vertex(group, this->random_);
    const Target target = choose_target(group);
    const auto expanded = this->expand(vertex, group, target, watch);
    if (this->status() != Status::searching) return;
    const bool long_way = expanded.last.step > this->parameters_.max_steps;
    if (long_way && expanded.result == Expansion::target_reached) this->guide_.unselect(this->regions_, group);
    if (expanded.result == Expansion::collision) raise_costs(expanded.region);
    if (this->statistics_.iterations % this->parameters_.kappa == 0) update_costs();
  }

  // Algorithm 2, lines 2 and 3: a region among the first of the shortest path after the group's, a point in it; now and
  // then any point of the workspace, which ends long series of failures at one place.
  Target choose_target(Index group) {
    const float stray = this->parameters_.stray_share;
    const std::uint32_t tries = this->guide_.selections(group);
    if (stray > 0.0F && this->random_.unit() < stray) return this->any_way_to(this->random_point_in_bounds(), tries);
    const Regions& regions = this->regions_;
    const Index region = regions.random_ahead(group, this->parameters_.path_regions, this->random_);
    const Vec2 point = regions.random_point(region, this->random_);
    return this->any_way_to(point, tries);
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
};

}  // namespace krait
