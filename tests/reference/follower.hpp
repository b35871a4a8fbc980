// SPDX-License-Identifier: Apache-2.0
// Follows a search step by step and holds every decision against Algorithms 1 and 2, written here from the paper in
// double precision: which group is selected (Eqns 5 to 8), how long an expansion is and how it ends, which edges rise
// (Eqn 9) and when the costs are found anew. Where two ways are equally short within rounding, the search may choose.
#pragma once

#include <algorithm>
#include <optional>

#include "decomposition.hpp"
#include "decomposition/locate.hpp"
#include "expansion.hpp"
#include "planner_fixture.hpp"

namespace krait::test::reference {

// What the paper leaves open or what we changed, as a search should have it.
struct Rules {
  double alpha, beta, epsilon;              // Eqn 7
  double gamma = 0;                         // Eqn 9; 0: costs never change
  double cost_length = 0;                   // metres: the length in Eqn 9; 0: as printed
  std::uint64_t kappa = 1;                  // Algorithm 1, line 5
  bool raise_goal = true;                   // whether failures before the goal raise its edges
  std::uint32_t max_steps = 40;             // Algorithm 2, line 4
  double near = 0;                          // metres: NEAR
  double goal_near = 0;                     // metres: NEAR of a target in the goal
  double path_reach = 0;                    // metres: targets lie in regions of the path within it, too
  std::uint32_t doomed_steps = 0;           // states before a collision that join no group
  std::uint32_t sample = kUnboundedSample;  // of a group
  std::uint64_t restart_unit = 0;           // expansions
  double least_width = 0;                   // metres, of portals
  double least_cost = 0;                    // metres, of edges
  double reach = 0;                         // metres from a position that one step can touch
  double goal_depth = 0;                    // metres inside the goal that count
};

enum class Result { goal_reached, target_reached, target_not_reached, collision };

// The units that the tries of Luby, Sinclair and Zuckerman last: 1, 1, 2, 1, 1, 2, 4, …
inline std::uint64_t luby(std::uint64_t i) {
  std::uint64_t power = 1;
  while (2 * power - 1 < i) power *= 2;
  return i == 2 * power - 1 ? power : luby(i - (power - 1));
}

template <class P>
class Follower {
 public:
  Follower(P& planner, const Scene& scene, Index goal, const float* start, const Rules& rules,
           std::uint32_t path_regions)
      : planner_(&planner),
        scene_(&scene),
        goal_(ring(scene.goal_polygon(goal))),
        rules_(rules),
        path_regions_(path_regions),
        goal_index_(goal),
        regions_(fresh_regions()),
        start_region_(region_of({start[0], start[1]}, kNone)) {
    note_ways();
    unit_ = unit();
    begin_try();
  }

  // One iteration of the search. The expansion, or none where the search began anew.
  std::optional<Expansion> follow() {
    const std::vector<std::uint32_t> selections = core_selections();
    const std::uint64_t restarts = planner_->statistics().restarts;
    Expansion expansion;
    const Watch<P> watch(*planner_, selections, expansion);
    (void)planner_->advance(1, watch);
    ++iterations_;
    const bool anew = unit_ > 0 && iterations_ == try_ends_ + 1;
    EXPECT_EQ(planner_->statistics().restarts > restarts, anew);
    EXPECT_EQ(expansion.begun, !anew);
    if (anew) {
      begin_try();
    } else if (expansion.begun) {
      check_selection(expansion);
      expansion.ahead = ahead(expansion.group);
      learn(expansion);
      if (result_ == Result::goal_reached) expect_plan();
    }
    if (planner_->status() == Status::searching && !refused_) check_tables();
    note_ways();
    return expansion.begun ? std::optional(expansion) : std::nullopt;
  }

  const Decomposition& regions() const { return regions_; }
  Result result() const { return result_; }
  bool refused() const { return refused_; }
  std::uint32_t selections(Index region) const { return selections_[region]; }
  std::uint64_t updates() const { return updates_; }
  std::uint64_t goal_raises() const { return goal_raises_; }
  std::uint64_t doomed() const { return doomed_; }

 private:
  static constexpr double kRounding = 1e-4;  // of costs and heuristic costs, in floats
  static constexpr double kGrid = 5e-4;      // metres: positions are located on a grid

  // Expansions of the first try: restart_unit where the way has 90 regions, less on a shorter way.
  std::uint64_t unit() const {
    double regions = 0;
    for (Index r = next(start_region_); r != kNone; r = next(r)) ++regions;
    const double way = regions / 90;
    EXPECT_LT(way, 1);
    return static_cast<std::uint64_t>(static_cast<double>(rules_.restart_unit) * std::max(way * way, 0.1));
  }

  Decomposition fresh_regions() const { return {*scene_, goal_index_, rules_.least_width, rules_.least_cost}; }

  void begin_try() {
    if (unit_ > 0) try_ends_ += unit_ * luby(++tries_);
    regions_ = fresh_regions();
    reached_.assign(scene_->triangle_count(), 0);
    selections_.assign(scene_->triangle_count(), 0);
    reached_[start_region_] = 1;
    raised_ = false;
  }

  std::vector<std::uint32_t> core_selections() const {
    std::vector<std::uint32_t> selections;
    for (Index r = 0; r < scene_->triangle_count(); ++r) selections.push_back(planner_->groups().selections(r));
    return selections;
  }

  // The search's own shortest ways, which its next iteration begins with.
  void note_ways() {
    ways_.clear();
    for (Index r = 0; r < scene_->triangle_count(); ++r) ways_.push_back(planner_->regions().next(r));
  }

  // The search's choice, which must be a shortest way but for rounding.
  Index next(Index region) const {
    const Index chosen = ways_[region];
    if (region == regions_.goal_region() || regions_.h(region) == kNoPath) {
      EXPECT_EQ(chosen, kNone);
      return kNone;
    }
    EXPECT_LE(regions_.detour(region, chosen), kRounding * (1 + regions_.h(region))) << region << " to " << chosen;
    return chosen;
  }

  // The regions after `region` on its shortest path, path_regions_ of them at most, or more, of 32, until one's
  // centroid is too far away; where there is none, itself.
  std::vector<Index> ahead(Index region) const {
    constexpr std::size_t kMost = 32;
    std::vector<Index> found;
    for (Index r = next(region); r != kNone; r = next(r)) {
      const bool near = found.size() < kMost && regions_.apart(region, r) < rules_.path_reach;
      if (found.size() >= path_regions_ && !near) break;
      found.push_back(r);
    }
    if (found.empty()) found.push_back(region);
    return found;
  }

  // Likewise of a position on the edge of regions; one that no region contains is in the last one.
  Index region_of(Vec2 p, Index last) const {
    const std::vector<Index> found = regions_.around(point(p), kGrid);
    if (found.size() == 1) return found.front();
    const Index triangle = detail::locate(*scene_, p, last);
    const Index chosen = triangle == kNone ? last : regions_.region(triangle);
    const bool among = std::find(found.begin(), found.end(), chosen) != found.end();
    EXPECT_TRUE(found.empty() ? triangle == kNone : among) << p.x << " " << p.y;
    return chosen;
  }

  // Eqn 7, as a logarithm.
  double log_weight(Index region) const {
    const double progress = rules_.epsilon + 1 - regions_.h(region) / regions_.largest_h();
    return rules_.alpha * std::log(progress) + std::log(rules_.beta) * selections_[region];
  }

  // Eqn 8.
  void check_selection(const Expansion& expansion) {
    ASSERT_EQ(expansion.selected, 1U);
    ASSERT_GT(reached_[expansion.group], 0U);
    double most = -kNoPath;
    for (Index r = 0; r < reached_.size(); ++r) {
      if (reached_[r] > 0 && regions_.h(r) < kNoPath) most = std::max(most, log_weight(r));
    }
    EXPECT_GE(log_weight(expansion.group), most - 2e-3) << "group " << expansion.group;
    ++selections_[expansion.group];
    EXPECT_TRUE(regions_.contains(expansion.group, expansion.path.front(), kGrid));
  }

  // Algorithm 2, lines 4 to 15, and Algorithm 1, lines 8 to 12.
  void learn(const Expansion& expansion) {
    EXPECT_FALSE(expansion.broken);
    result_ = result_of(expansion);
    std::vector<Index> regions;  // of its states
    Index last = expansion.group;
    for (std::size_t i = 1; i < expansion.path.size(); ++i) {
      const Point at = expansion.path[i];
      last = region_of({static_cast<float>(at.x), static_cast<float>(at.y)}, last);
      regions.push_back(last);
    }
    if (result_ == Result::goal_reached) return;
    std::size_t kept = regions.size();
    if (result_ == Result::collision) kept -= std::min<std::size_t>(kept, rules_.doomed_steps);
    doomed_ += regions.size() - kept;
    for (std::size_t i = 0; i < kept; ++i) ++reached_[regions[i]];
    if (result_ == Result::collision) raise(last);
    if (iterations_ % rules_.kappa == 0 && raised_) update();
  }

  Result result_of(const Expansion& expansion) const {
    const std::vector<Point>& path = expansion.path;
    const std::size_t steps = path.size() - 1;
    EXPECT_LE(steps, rules_.max_steps);
    const double target_depth = depth_in_goal(point(expansion.target.point));  // near 0 it may count as either
    const double goes_on = target_depth < -kGrid * 0.01 ? rules_.near : std::min(rules_.near, rules_.goal_near);
    const double reached = target_depth > kGrid * 0.01 ? rules_.goal_near : std::max(rules_.near, rules_.goal_near);
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      EXPECT_GE(target_distance(expansion, i), goes_on - kGrid * 0.01) << "went on from its target";
      EXPECT_LE(depth_in_goal(path[i]), rules_.goal_depth + kGrid * 0.01) << "went on from the goal";
    }
    const double depth = depth_in_goal(path.back());
    if (steps > 0 && depth > rules_.goal_depth + kGrid * 0.01) return Result::goal_reached;
    if (planner_->status() == Status::solved) {
      EXPECT_GE(depth, rules_.goal_depth - kGrid * 0.01);
      return Result::goal_reached;
    }
    if (steps > 0 && target_distance(expansion, steps) <= reached) return Result::target_reached;
    if (steps == rules_.max_steps) return Result::target_not_reached;
    if (rules_.reach > 0) {
      EXPECT_LE(room(path.back()), rules_.reach) << "ended with nothing to collide with";
    }
    return Result::collision;
  }

  // A search that has reached the goal has a plan, perhaps some calls later, and makes no expansion any more; unless
  // the way does not hold as it is driven once more, which the paper has nothing about: nothing is followed from there.
  void expect_plan() {
    const std::vector<std::uint32_t> selections = core_selections();
    Expansion expansion;
    const Watch<P> watch(*planner_, selections, expansion);
    const std::uint64_t refused = planner_->statistics().plans_refused;
    for (int i = 0; i < 100'000 && planner_->status() == Status::searching && !expansion.begun; ++i) {
      (void)planner_->advance(1, watch);
      refused_ = planner_->statistics().plans_refused > refused;
      if (refused_) return;
    }
    EXPECT_EQ(planner_->status(), Status::solved);
    EXPECT_FALSE(expansion.begun);
  }

  static double target_distance(const Expansion& expansion, std::size_t i) {
    return distance(expansion.path[i], point(expansion.target.point));
  }

  // Of a convex goal, counter-clockwise; negative outside.
  double depth_in_goal(Point p) const {
    double least = kNoPath;
    for (std::size_t i = 0; i < goal_.size(); ++i) {
      const Point a = goal_[i], b = goal_[(i + 1) % goal_.size()];
      least = std::min(least, side(a, b, p) / distance(a, b));
    }
    return least;
  }

  // From a position to the nearest obstacle or bound.
  double room(Point p) const {
    const Box bounds = scene_->bounds();
    const Point low = point(bounds.min), high = point(bounds.max);
    double least = std::min(std::min(p.x - low.x, high.x - p.x), std::min(p.y - low.y, high.y - p.y));
    for (Index i = 0; i < scene_->piece_count(); ++i) {
      least = std::min(least, distance_to_convex(p, ring(scene_->piece(i))));
    }
    return least;
  }

  // Line 10 and 11: the edges of the region after that of the last vertex.
  void raise(Index last) {
    const Index raised = next(last);
    if (rules_.gamma <= 0 || raised == kNone) return;
    const bool goal = raised == regions_.goal_region();
    goal_raises_ += goal ? 1 : 0;
    if (goal && !rules_.raise_goal) return;
    regions_.raise_edges_of(raised, rules_.gamma, rules_.cost_length);
    raised_ = true;
  }

  void update() {
    raised_ = false;
    ++updates_;
    regions_.update();
  }

  // The search's own tables after an iteration: heuristic costs, and how many states ever joined which group.
  void check_tables() const {
    for (Index r = 0; r < reached_.size(); ++r) {
      if (regions_.region(r) != r) continue;
      const double core = double{planner_->regions().cost(r)};
      if (regions_.h(r) == kNoPath) {
        ASSERT_EQ(core, kNoPath);
      } else {
        ASSERT_NEAR(core, regions_.h(r), kRounding * (1 + regions_.h(r))) << "iteration " << iterations_ << ", " << r;
      }
      ASSERT_EQ(planner_->groups().reached(r), reached_[r]) << "iteration " << iterations_ << ", region " << r;
      ASSERT_EQ(planner_->groups().size(r), std::min(reached_[r], rules_.sample));
    }
  }

  P* planner_;
  const Scene* scene_;
  Ring goal_;
  Rules rules_;
  std::uint32_t path_regions_;
  Index goal_index_;
  Decomposition regions_;
  Index start_region_;
  std::vector<std::uint32_t> reached_;
  std::vector<std::uint32_t> selections_;
  std::vector<Index> ways_;
  bool raised_ = false;
  Result result_ = Result::target_not_reached;
  bool refused_ = false;
  std::uint64_t iterations_ = 0;
  std::uint64_t unit_ = 0;  // expansions of the first try
  std::uint64_t tries_ = 0;
  std::uint64_t try_ends_ = 0;  // the last iteration of the try
  std::uint64_t updates_ = 0;
  std::uint64_t goal_raises_ = 0;
  std::uint64_t doomed_ = 0;
};

}  // namespace krait::test::reference
