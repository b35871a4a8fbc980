// The planner of prior work that the paper compares with: [18] E. Plaku, Robot Motion Planning with Dynamics as Hybrid
// Search, AAAI 2013. Tree, groups and shortest paths are Algorithm 1's, but edge costs never change.
#pragma once

#include "krait/search/groups.hpp"
#include "krait/search/search.hpp"

namespace krait {

// A group's weight is (epsilon + (1 - epsilon) (h_max - h) / (h_max - h_min))^alpha beta^selections. h_min is the
// goal's 0, and 1 - epsilon is 1 in float: Eqn 7 with another epsilon.
template <Robot R>
class PriorPlanner : public Search<R, Groups> {
  using Base = Search<R, Groups>;
  using Expansion = typename Base::Expansion;

 public:
  // As Planner's.
  Status start(const Query& query) {
    if (!this->ready()) return this->status();
    this->guide_.clear({this->parameters_.alpha, this->parameters_.beta, this->parameters_.prior.epsilon});
    if (this->begin(query) == Status::searching) add_to_group(0);
    return this->status();
  }

  // As Planner's; an expansion also looks at every vertex of its group.
  Status advance(std::uint64_t iterations) {
    for (; iterations > 0 && this->status() == Status::searching; --iterations) iterate();
    return this->status();
  }

  const Groups& groups() const { return this->guide_; }

 private:
  static constexpr int kMaxTries = 16;  // at a point outside obstacles

  void add_to_group(Index vertex) { this->guide_.insert(this->regions_, this->tree_.region(vertex), vertex); }

  void iterate() {
    if (!this->count_iteration()) return;
    const Index group = this->guide_.select();
    const Vec2 point = choose_point(group);
    const Index vertex = choose_vertex(group, point);
    const auto expanded = this->expand(vertex, this->target_at(point), [this](Index added) { add_to_group(added); });
    if (expanded.result == Expansion::goal_reached) {
      this->finish_solved(expanded.last);
    } else if (expanded.result == Expansion::tree_full) {
      this->finish(Status::tree_full);
    }
  }

  // Where to steer: mostly into a region ahead, at times to the goal or anywhere.
  Vec2 choose_point(Index group) {
    const PriorParameters& prior = this->parameters_.prior;
    const Regions& regions = this->regions_;
    const float choice = this->random_.unit();
    if (choice < prior.path_share) {
      const Index region = regions.random_ahead(group, prior.path_regions, this->random_);
      return regions.random_point(region, this->random_);
    }
    if (choice < prior.path_share + prior.goal_share) return regions.random_goal_point(this->random_);
    return random_free_point();
  }

  // Uniform over the triangles' union, by rejection from the bounds; the last try in an obstacle stands.
  Vec2 random_free_point() {
    Vec2 point = this->random_point_in_bounds();
    for (int tries = 1; tries < kMaxTries && locate(*this->scene_, point) == kNone; ++tries) {
      point = this->random_point_in_bounds();
    }
    return point;
  }

  Index choose_vertex(Index group, Vec2 point) {
    const bool nearest = this->random_.unit() < this->parameters_.prior.nearest_share;
    return nearest ? nearest_vertex(group, point) : this->guide_.random_vertex(group, this->random_);
  }

  // By position; the oldest among equals.
  Index nearest_vertex(Index group, Vec2 point) const {
    Index best = kNone;
    float least = kInfinity;
    this->guide_.for_each_vertex(group, [&](Index vertex) {
      const float* state = this->tree_.state(vertex);
      const Vec2 apart = point - Vec2{state[0], state[1]};
      const float squared = dot(apart, apart);
      if (squared > least || (squared == least && vertex > best)) return;
      least = squared;
      best = vertex;
    });
    return best;
  }
};

}  // namespace krait
