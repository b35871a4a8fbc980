// SPDX-License-Identifier: Apache-2.0
// D = (R, E, C) of the paper's section 4.1 with Eqns 4 and 9 and the heuristic costs h, in double precision and the
// plain way: a map of edges, and Bellman and Ford's sweeps until nothing changes.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "regions_around.hpp"
#include "scene_builder.hpp"

namespace krait::test::reference {

constexpr double kNoPath = std::numeric_limits<double>::infinity();

inline Point minus(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

class Decomposition {
 public:
  // Regions are the triangles; those of the goal are one, named by the first of them. Portals narrower than
  // `least_width` are no edges, edges cost at least `least_cost`.
  Decomposition(const Scene& scene, Index goal, double least_width, double least_cost)
      : scene_(&scene), goal_(goal), h_(scene.triangle_count(), kNoPath) {
    for (Index t = scene.triangle_count(); t-- > 0;) {
      if (scene.goal_of(t) == goal) goal_region_ = t;
    }
    for (Index t = 0; t < scene.triangle_count(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const Index n = scene.neighbor(t, i);
        if (n == kNone || region(n) == region(t)) continue;
        if (double{scene.portal_width(scene.portal(t, i))} < least_width) continue;
        edge(region(t), region(n)) = std::max(least_cost, distance(centroid(region(t)), centroid(region(n))));
      }
    }
    base_ = costs_;
    update();
  }

  Index count() const { return scene_->triangle_count(); }
  Index goal_region() const { return goal_region_; }
  Index region(Index triangle) const { return scene_->goal_of(triangle) == goal_ ? goal_region_ : triangle; }
  // As of the last update.
  double h(Index region) const { return h_[region]; }
  double largest_h() const {
    double most = 0;
    for (const double h : h_) most = std::max(most, h < kNoPath ? h : 0.0);
    return most;
  }

  // Metres between the centroids of two regions.
  double apart(Index a, Index b) const { return distance(centroid(a), centroid(b)); }

  // How much longer a way from `region` is that goes to `next` first; by the costs of the last update.
  double detour(Index region, Index next) const {
    const auto found = known_.find(std::minmax(region, next));
    return found == known_.end() ? kNoPath : found->second + h_[next] - h_[region];
  }

  // Eqn 9, in the form of CostRaise.
  void raise_edges_of(Index region, double gamma, double length) {
    const auto joins = [this](Index a, Index b) {
      return this->region(b) != goal_region_ && costs_.count(std::minmax(a, b)) > 0;
    };
    const auto apart_of = [this](Index a, Index b) { return apart(a, b); };
    const double reach = region == goal_region_ ? 0 : 0.35 * length;
    const std::vector<Index> around = regions_around(*scene_, region, reach, joins, apart_of);
    const std::set<Index> raised(around.begin(), around.end());
    for (auto& [ends, cost] : costs_) {
      if (raised.count(ends.first) + raised.count(ends.second) == 0) continue;
      const double scale = length > 0 ? length * std::min(base_.at(ends), length) : 1;
      cost += gamma * scale / std::max(cost, length);
    }
  }

  void update() {
    known_ = costs_;
    std::fill(h_.begin(), h_.end(), kNoPath);
    h_[goal_region_] = 0;
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [ends, cost] : costs_) {
        const auto [a, b] = ends;
        changed = shorten(a, h_[b] + cost) || changed;
        changed = shorten(b, h_[a] + cost) || changed;
      }
    }
  }

  double area(Index region) const {
    double total = 0;
    for_each_triangle(region, [&](Index t) { total += triangle_area(t); });
    return total;
  }

  // The regions that a point lies in or within `tolerance` metres of.
  std::vector<Index> around(Point p, double tolerance) const {
    std::vector<Index> found;
    for (Index r = 0; r < count(); ++r) {
      if (region(r) == r && contains(r, p, tolerance)) found.push_back(r);
    }
    return found;
  }

  // Whether a point lies in the region or within `tolerance` metres of it.
  bool contains(Index region, Point p, double tolerance) const {
    bool found = false;
    for_each_triangle(region, [&](Index t) { found = found || triangle_contains(t, p, tolerance); });
    return found;
  }

 private:
  double& edge(Index a, Index b) { return costs_[std::minmax(a, b)]; }

  bool shorten(Index region, double way) {
    if (!(way < h_[region])) return false;
    h_[region] = way;
    return true;
  }

  template <class Visit>
  void for_each_triangle(Index named, Visit visit) const {
    if (named != goal_region_) return visit(named);
    for (Index t = 0; t < count(); ++t) {
      if (region(t) == named) visit(t);
    }
  }

  Point corner(Index triangle, int i) const { return point(scene_->corner(triangle, i)); }

  double triangle_area(Index t) const { return 0.5 * side(corner(t, 0), corner(t, 1), corner(t, 2)); }

  bool triangle_contains(Index t, Point p, double tolerance) const {
    for (int i = 0; i < 3; ++i) {
      const Point a = corner(t, i), b = corner(t, (i + 1) % 3);
      if (side(a, b, p) < -tolerance * distance(a, b)) return false;
    }
    return true;
  }

  // Of the goal: of all its triangles together.
  Point centroid(Index named) const {
    Point sum{0, 0};
    for_each_triangle(named, [&](Index t) {
      for (int i = 0; i < 3; ++i) {
        sum.x += triangle_area(t) * corner(t, i).x / 3;
        sum.y += triangle_area(t) * corner(t, i).y / 3;
      }
    });
    return {sum.x / area(named), sum.y / area(named)};
  }

  using Costs = std::map<std::pair<Index, Index>, double>;

  const Scene* scene_;
  Index goal_;
  Index goal_region_ = kNone;
  Costs costs_;
  Costs base_;   // before the first raise
  Costs known_;  // of the last update
  std::vector<double> h_;
};

}  // namespace krait::test::reference
