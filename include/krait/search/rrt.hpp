// RRT, the other planner that the paper compares with: [14] S. LaValle, J. Kuffner, Randomized Kinodynamic Planning,
// IJRR 2001, in the version that connects: from the vertex nearest to a random point the tree grows until the point is
// reached or a step collides.
#pragma once

#include "krait/search/nearest.hpp"
#include "krait/search/search.hpp"

namespace krait {

template <Robot R>
class RrtPlanner : public Search<R, NearestPoints> {
  using Base = Search<R, NearestPoints>;
  using Expansion = typename Base::Expansion;

 public:
  // As Planner's: the regions tell whether there is a route at all, and guide nothing.
  Status start(const Query& query) {
    if (!this->ready()) return this->status();
    this->guide_.clear();
    connecting_ = kNone;
    if (this->begin(query) == Status::searching) insert(0);
    return this->status();
  }

  // As Planner's; an iteration also searches the nearest vertex, O(vertices) at worst.
  Status advance(std::uint64_t iterations) {
    for (; iterations > 0 && this->status() == Status::searching; --iterations) iterate();
    return this->status();
  }

 private:
  Vec2 position(Index vertex) const { return {this->tree_.state(vertex)[0], this->tree_.state(vertex)[1]}; }
  void insert(Index vertex) { this->guide_.insert(position(vertex)); }

  // A connection longer than one expansion goes on in the next iteration.
  void iterate() {
    if (!this->count_iteration()) return;
    if (connecting_ == kNone) begin_connection();
    const auto expanded = this->expand(connecting_, target_, [this](Index added) { insert(added); });
    connecting_ =
        expanded.result == Expansion::target_not_reached && comes_closer(expanded.last) ? expanded.last : kNone;
    if (expanded.result == Expansion::goal_reached) {
      this->finish_solved(expanded.last);
    } else if (expanded.result == Expansion::tree_full) {
      this->finish(Status::tree_full);
    }
  }

  void begin_connection() {
    const bool to_goal = this->random_.unit() < this->parameters_.rrt.goal_share;
    const Vec2 point = to_goal ? this->regions_.random_goal_point(this->random_) : this->random_point_in_bounds();
    target_ = this->target_at(point);
    connecting_ = this->guide_.nearest(point);
  }

  // Whether an expansion from connecting_ to `last` was not in vain: a robot may circle its target for ever.
  bool comes_closer(Index last) const {
    return length(target_.point - position(last)) < length(target_.point - position(connecting_));
  }

  Target target_;
  Index connecting_ = kNone;  // the vertex that a connection goes on from, or none
};

}  // namespace krait
