// Algorithm 1: the motion tree grows from the group with the largest weight toward the goal along the shortest path of
// regions; failures raise edge costs, and the shortest paths are found again.
#pragma once

#include "krait/search/groups.hpp"
#include "krait/search/search.hpp"

namespace krait {

template <Robot R>
class Planner : public Search<R, Groups> {
  using Base = Search<R, Groups>;
  using Expansion = typename Base::Expansion;

 public:
  // Begins a search, ending any other. Gives searching; or solved, when the start lies in the goal; or no_route,
  // goal_in_obstacle, start_outside, start_in_collision, bad_argument. Work: one Dijkstra.
  Status start(const Query& query) {
    if (!this->ready()) return this->status();
    this->guide_.clear({this->parameters_.alpha, this->parameters_.beta, this->parameters_.epsilon});
    raised_ = false;
    if (this->begin(query) == Status::searching) add_to_group(0);
    return this->status();
  }

  // At most `iterations` expansions more (Algorithm 1, lines 4 to 13); returns at once when the search has ended.
  // The result does not depend on how a search is cut into calls.
  Status advance(std::uint64_t iterations) {
    for (; iterations > 0 && this->status() == Status::searching; --iterations) iterate();
    return this->status();
  }

  const Groups& groups() const { return this->guide_; }

 private:
  void add_to_group(Index vertex) { this->guide_.insert(this->regions_, this->tree_.region(vertex), vertex); }

  void iterate() {
    if (!this->count_iteration()) return;
    const Index group = this->guide_.select();
    const Index vertex = this->guide_.random_vertex(group, this->random_);
    const Target target = choose_target(group);
    const auto expanded = this->expand(vertex, target, [this](Index added) { add_to_group(added); });
    if (expanded.result == Expansion::goal_reached) {
      this->finish_solved(expanded.last);
    } else if (expanded.result == Expansion::tree_full) {
      this->finish(Status::tree_full);
    } else {
      if (expanded.result == Expansion::collision) raise_costs(this->tree_.region(expanded.last));
      if (this->statistics_.iterations % this->parameters_.kappa == 0) update_costs();
    }
  }

  // Algorithm 2, lines 2 and 3: a region among the first of the shortest path after the group's, a point in it; now and
  // then any point of the workspace, which ends long series of failures at one place.
  Target choose_target(Index group) {
    const float stray = this->parameters_.stray_share;
    if (stray > 0.0F && this->random_.unit() < stray) return this->target_at(this->random_point_in_bounds());
    const Regions& regions = this->regions_;
    const Index region = regions.random_ahead(group, this->parameters_.path_regions, this->random_);
    const Vec2 point = regions.random_point(region, this->random_);
    return this->target_at(point);
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
    this->regions_.update();
    this->guide_.weigh(this->regions_);
    ++this->statistics_.dijkstra_runs;
  }

  bool raised_ = false;
};

}  // namespace krait
