// SPDX-License-Identifier: Apache-2.0
// The random choices of a search against their shares: the vertex of a group, the region and point of a target, strays,
// speeds, gentle turns, driving backwards.
#pragma once

#include "follower.hpp"
#include "tally.hpp"

namespace krait::test::reference {

struct Shares {
  std::uint32_t path_regions = 8;  // Algorithm 2, line 2: the "first few"
  double ahead = 1;                // of targets in them
  double goal = 0;                 // of targets in the goal
  bool strays_in_bounds = true;    // where the rest is uniform: in the bounds, or in the free triangles
  double nearest = 0;              // how often the vertex nearest to the target grows
  double slowest = 1;              // share of the top speed
  double reverse = 0;
  double gentle = 0;  // of targets for a group that was often selected
};

class Choices {
 public:
  explicit Choices(const Shares& shares) : shares_(shares) {}

  template <class P>
  void add(const P& planner, const Follower<P>& follower, const Scene& scene, const Expansion& expansion) {
    add_vertex(planner, expansion);
    add_target(follower.regions(), scene, expansion);
    const double often = tried(follower.selections(expansion.group));
    add_speed(expansion.target, often);
    add_turn(expansion.target, often);
  }

  void expect() const {
    vertices_.expect("vertices, each of a group as likely", 100);
    elsewhere_.expect("targets elsewhere than in the regions ahead", 300);
    regions_.expect("regions ahead, each as likely", 100);
    for (const Tally& tally : corners_) tally.expect("points of a region, each as likely", 100);
    speeds_.expect("speeds", shares_.slowest < 1 ? 300 : 0);
    backwards_.expect("driving backwards", 300);
    gentle_.expect("gentle turns", 300);
    nearest_.expect("the vertex nearest to the target", shares_.nearest > 0 ? 100 : 0);
    EXPECT_TRUE(seen_farthest_) << "no target in the farthest of the regions ahead";
  }

 private:
  static constexpr double kUnit = 2e-3;  // metres: targets are stored to 1/65535 of the bounds

  template <class P>
  void add_vertex(const P& planner, const Expansion& expansion) {
    const auto& members = expansion.members;
    const auto at = std::find(members.begin(), members.end(), expansion.vertex);
    ASSERT_NE(at, members.end()) << "a vertex of another group grows";
    if (members.size() < 2) return;
    const auto n = static_cast<double>(members.size());
    if (shares_.nearest > 0) return add_nearest(planner, expansion, n);
    const double rank = (static_cast<double>(at - members.begin()) + 0.5) / n;
    vertices_.add(rank, 0.5, (1 - 1 / (n * n)) / 12);
  }

  template <class P>
  void add_nearest(const P& planner, const Expansion& expansion, double n) {
    const Point target = point(expansion.target.point);
    const auto away = [&](Index vertex) {
      const float* state = planner.tree().state(vertex);
      return distance(target, point({state[0], state[1]}));
    };
    double least = kNoPath;
    for (const Index member : expansion.members) {
      if (member != expansion.vertex) least = std::min(least, away(member));
    }
    const double own = away(expansion.vertex);
    if (std::abs(own - least) < 2 * kUnit) return;  // either may be the nearest
    nearest_.add(own < least, shares_.nearest + (1 - shares_.nearest) / n);
    vertices_.add(0.5, 0.5, 0);
  }

  void add_target(const Decomposition& d, const Scene& scene, const Expansion& expansion) {
    const std::vector<Index>& ahead = expansion.ahead;
    const Point p = point(expansion.target.point);
    std::vector<std::size_t> hit;
    for (std::size_t i = 0; i < ahead.size(); ++i) {
      if (d.contains(ahead[i], p, kUnit)) hit.push_back(i);
    }
    const bool goal_is_ahead = ahead.back() == d.goal_region();
    const bool in_goal = shares_.goal > 0 && !goal_is_ahead && d.contains(d.goal_region(), p, kUnit);
    double area = 0;
    for (const Index region : ahead) area += d.area(region);
    if (shares_.goal > 0 && !goal_is_ahead) area += d.area(d.goal_region());
    const double rest = (1 - shares_.ahead - shares_.goal) * (1 - area / stray_area(d, scene));
    const bool elsewhere = hit.empty() && !in_goal;
    if (rest <= 0) {
      EXPECT_FALSE(elsewhere) << "a target in none of the regions ahead: " << p.x << " " << p.y;
    }
    elsewhere_.add(elsewhere, rest);
    if (elsewhere && !shares_.strays_in_bounds) {
      EXPECT_TRUE(is_free(d, p)) << "a target in an obstacle: " << p.x << " " << p.y;
    }
    if (in_goal && hit.empty()) return;
    if (hit.size() == 1) add_region(d, scene, ahead, hit.front(), p);
  }

  static bool is_free(const Decomposition& d, Point p) {
    for (Index r = 0; r < d.count(); ++r) {
      if (d.region(r) == r && d.contains(r, p, kUnit)) return true;
    }
    return false;
  }

  double stray_area(const Decomposition& d, const Scene& scene) const {
    if (shares_.strays_in_bounds) {
      const Point low = point(scene.bounds().min), high = point(scene.bounds().max);
      return (high.x - low.x) * (high.y - low.y);
    }
    double area = 0;
    for (Index r = 0; r < d.count(); ++r) area += d.region(r) == r ? d.area(r) : 0;
    return area;
  }

  void add_region(const Decomposition& d, const Scene& scene, const std::vector<Index>& ahead, std::size_t i, Point p) {
    const auto n = static_cast<double>(ahead.size());
    if (ahead.size() > 1) regions_.add((static_cast<double>(i) + 0.5) / n, 0.5, (1 - 1 / (n * n)) / 12);
    seen_farthest_ = seen_farthest_ || i + 1 == shares_.path_regions;
    if (ahead[i] == d.goal_region()) return;
    Point corners[3];
    for (int k = 0; k < 3; ++k) corners[k] = point(scene.corner(ahead[i], k));
    const double whole = side(corners[0], corners[1], corners[2]);
    for (int k = 0; k < 3; ++k) {
      const double share = side(corners[(k + 1) % 3], corners[(k + 2) % 3], p) / whole;
      corners_[k].add(share, 1.0 / 3, 1.0 / 18);
    }
  }

  // The share of their most with which gentle turns and driving backwards occur after so many selections.
  static double tried(std::uint32_t selections) {
    constexpr double kPatience = 10;
    return selections / (selections + kPatience);
  }

  void add_speed(const Target& target, double often) {
    const double speed = std::abs(double{target.speed});
    EXPECT_GE(speed, shares_.slowest - 1e-4);
    EXPECT_LE(speed, 1.0);
    speeds_.add_uniform(speed, shares_.slowest, 1);
    backwards_.add(target.speed < 0, shares_.reverse * often);
  }

  void add_turn(const Target& target, double often) {
    constexpr double kGentlest = 0.15;
    const bool gentle = target.turn < 1;
    EXPECT_GE(double{target.turn}, kGentlest - 1e-4);
    gentle_.add(gentle, shares_.gentle * often);
  }

  Shares shares_;
  Tally vertices_, elsewhere_, regions_, speeds_, backwards_, gentle_, nearest_;
  Tally corners_[3];
  bool seen_farthest_ = false;
};

}  // namespace krait::test::reference
