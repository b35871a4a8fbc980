// Algorithm 1: the motion tree grows from the group with the largest weight toward the goal along the shortest path of
// regions; failures raise edge costs, and the shortest paths are found again.
#pragma once

#include "krait/search/groups.hpp"
#include "krait/search/search.hpp"

namespace krait {

template <Robot R>
class Planner : public Search<R> {
  using Base = Search<R>;
  using Expansion = typename Base::Expansion;

 public:
  // Bytes of the block that init needs. The same on every target. O(1).
  static std::uint64_t bytes_required(const Scene& scene, const R& robot, const Limits& limits) {
    Arena counting;
    Planner planner;
    planner.robot_ = &robot;
    planner.scene_ = &scene;
    planner.limits_ = limits;
    planner.take_all(counting);
    return counting.needed();
  }

  // The limits that spend a block of `bytes` best: as many vertices as fit, at least 2. O(1).
  static Limits limits_for(std::uint64_t bytes, const Scene& scene, const R& robot) {
    Limits limits;
    std::uint32_t fits = 2;
    std::uint32_t too_many = kMostVertices;
    while (too_many - fits > 1) {
      limits.vertices = fits + (too_many - fits) / 2;
      (bytes_required(scene, robot, limits) <= bytes ? fits : too_many) = limits.vertices;
    }
    limits.vertices = fits;
    return limits;
  }

  // Takes the block, which like robot and scene must outlive the planner and stay where it is. Gives solved, or why
  // not: bad_arithmetic, bad_robot, bad_argument, arena_too_small. May be called again.
  Failure init(void* block, std::uint64_t bytes, const Scene& scene, const R& robot, const Parameters& parameters,
               const Limits& limits) {
    ready_ = false;
    if (!this->check_setup(robot, scene, parameters, limits).ok()) return this->failure_;
    const std::uint64_t needed = bytes_required(scene, robot, limits);
    if (bytes < needed) return this->failure_ = {Status::arena_too_small, 0, 0, needed};
    const bool usable = block != nullptr && reinterpret_cast<std::uintptr_t>(block) % Arena::kAlignment == 0;
    if (!usable) return this->failure_ = Base::bad_argument(Argument::block);
    Arena arena(block, bytes);
    take_all(arena);
    this->statistics_ = {};
    this->statistics_.bytes_given = bytes;
    this->statistics_.bytes_used = needed;
    ready_ = true;
    return this->failure_ = {};
  }

  // Begins a search, ending any other. Gives searching; or solved, when the start lies in the goal; or no_route,
  // goal_in_obstacle, start_outside, start_in_collision, bad_argument. Work: one Dijkstra.
  Status start(const Query& query) {
    if (!ready_) return this->finish(Status::bad_argument);
    groups_.clear({this->parameters_.alpha, this->parameters_.beta, this->parameters_.epsilon});
    raised_ = false;
    if (this->begin(query) != Status::searching) return this->status();
    add_to_group(0);
    if (this->goal_.contains(*this->scene_, {query.start[0], query.start[1]}, 0.0F)) {
      return this->finish_solved(0, groups_.scratch());
    }
    return this->status();
  }

  // At most `iterations` expansions more (Algorithm 1, lines 4 to 13); returns at once when the search has ended.
  // The result does not depend on how a search is cut into calls.
  Status advance(std::uint64_t iterations) {
    for (; iterations > 0 && this->status() == Status::searching; --iterations) iterate();
    return this->status();
  }

  const Groups& groups() const { return groups_; }

 private:
  static constexpr std::uint32_t kMostVertices = 1U << 28U;

  void take_all(Arena& arena) {
    this->take_pools(arena);
    groups_.take(arena, this->scene_->triangle_count(), this->limits_.vertices);
  }

  void add_to_group(Index vertex) { groups_.insert(this->regions_, this->tree_.region(vertex), vertex); }

  void iterate() {
    if (this->statistics_.iterations == this->limits_.iterations) {
      this->finish(Status::budget_used);
      return;
    }
    ++this->statistics_.iterations;
    const Index group = groups_.select();
    const Index vertex = groups_.random_vertex(group, this->random_);
    const Target target = choose_target(group);
    const auto expanded = this->expand(vertex, target, [this](Index added) { add_to_group(added); });
    if (expanded.result == Expansion::goal_reached) {
      this->finish_solved(expanded.last, groups_.scratch());
    } else if (expanded.result == Expansion::tree_full) {
      this->finish(Status::tree_full);
    } else {
      if (expanded.result == Expansion::collision) raise_costs(this->tree_.region(expanded.last));
      if (this->statistics_.iterations % this->parameters_.kappa == 0) update_costs();
    }
  }

  // Algorithm 2, lines 2 and 3: a region among the first of the shortest path after the group's, a point in it.
  Target choose_target(Index group) {
    const Regions& regions = this->regions_;
    std::uint32_t length = 0;
    for (Index r = regions.next(group); r != kNone && length < this->parameters_.path_regions; r = regions.next(r)) {
      ++length;
    }
    const std::uint32_t position = length > 0 ? 1 + this->random_.below(length) : 0;
    Index region = group;
    for (std::uint32_t i = 0; i < position; ++i) region = regions.next(region);
    const Vec2 point = regions.random_point(region, this->random_);
    const float speed = this->random_speed();
    return {point, speed, this->parameters_.dt};
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
    groups_.weigh(this->regions_);
    ++this->statistics_.dijkstra_runs;
  }

  Groups groups_;
  bool raised_ = false;
  bool ready_ = false;
};

}  // namespace krait
