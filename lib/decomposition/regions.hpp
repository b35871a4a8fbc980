// SPDX-License-Identifier: Apache-2.0
// The workspace decomposition D = (R, E, C) (section 4.1), the heuristic costs h(r) and the shortest-path tree.
//
// A region is named by a triangle. All triangles of a named goal form the one region G, named by the first of them;
// a disc goal makes every triangle that it meets a source of its own. Edges are the portals between regions.
#pragma once

#include "base/arena.hpp"
#include "base/random.hpp"
#include "decomposition/indexed_heap.hpp"
#include "krait/goal.hpp"
#include "krait/scene.hpp"
#include "krait/status.hpp"

namespace krait::detail {

// How much a failed expansion raises an edge's cost C (Eqn 9).
struct CostRaise {
  float gamma;  // square metres in the paper's form, a plain number otherwise
  // Metres: C, which was C0 at first, rises by gamma * length * min(C0, length) / max(C, length), and so do the edges
  // of regions around; 0: C rises by gamma / C, as in the paper.
  float length;
};

class Regions {
 public:
  // Measured: bench/ABLATIONS.md, "Constants", and kRaiseReach also in "A failure raises what is around, too".
  static constexpr Index kMostAhead = 32;      // the last region that a distance can add
  static constexpr Index kMostRaised = 32;     // regions whose edges one failure raises
  static constexpr float kRaiseReach = 0.35F;  // as far around a region, in CostRaise::length

  Regions();

  // Allocates its tables: 9 bytes a triangle (13 from 65,536 on) and 4 a portal. The scene must outlive this.
  void allocate(Arena& arena, const Scene& scene);
  void allocate(Arena&, const Scene&&) = delete;

  // Costs C between centroids, but at least `least_cost` metres; portals narrower than `least_width` are no edges;
  // then Dijkstra. False when no triangle belongs to the goal.
  bool reset(const Goal& goal, float least_width, float least_cost);

  // Whether a disc could get from triangle `from` to within `reach` metres of the goal through portals of at least
  // `least_width`. Uses the tables as scratch: reset must follow. O(R).
  bool connected(Index from, const Goal& goal, float reach, float least_width);

  // The widest way from triangle `from` to within `reach` metres of the goal of the last reset (into it for 0), through
  // portals of any width, and its narrowest portal; `needed` is the caller's. Then recomputes h, as update does.
  // O(R log R).
  Bottleneck widest_way(Index from, float reach);

  // Dijkstra from the goal over the costs as they are: h and the shortest-path tree. O(R log R).
  void update();

  // The same, bit for bit, where edges were only raised since the last update or repair: recomputes the paths of those
  // regions only whose path crossed a raised edge. Returns how many. O(n log n) for n of them; O(R log R) where costs
  // have grown so large that h + C may be h. With `all` it finds them by update, for tests and measurements.
  Index repair(bool all = false);

  // The region of a triangle.
  Index region(Index triangle) const { return is_goal_triangle(triangle) ? goal_region_ : triangle; }
  // h(r), metres; infinite where no path leads to the goal.
  float cost(Index region) const { return h_[region]; }
  // Largest finite h (Eqn 7's h_max).
  float largest_cost() const { return largest_; }
  // The region after r on its shortest path, as of the last update; kNone at a goal and where there is no path.
  Index next(Index r) const;
  // The regions after r on its shortest path: the first `most`, and further ones, up to the kMostAhead-th, as long as
  // their centroids lie nearer to r's than `distance` metres. O(kMostAhead + most).
  Index regions_ahead(Index region, Index most, float distance = 0.0F) const;
  bool is_goal(Index region) const { return h_[region] == 0.0F; }
  // A named goal's one region; kNone for a disc.
  Index goal_region() const { return goal_region_; }
  const Goal& goal() const { return goal_; }
  const Scene& scene() const { return *scene_; }

  // Raises the cost of every edge of r (Algorithm 1, line 11). With a CostRaise::length also, once each, those of the
  // regions around it, unless r is a goal: the first kMostRaised, counted in portals from r, whose centroids lie nearer
  // to r's than kRaiseReach lengths, which are no goals, and which portals between such regions connect with r. So a
  // failure weighs as much among many small regions as in a large one. Costs h stay as they were. O(kMostRaised); for G
  // O(triangles from its first to its last).
  void raise_edges(Index region, const CostRaise& raise);
  // Whether edges were raised since h was found.
  bool raised() const { return raised_count_ > 0; }

  // A point drawn uniformly: in the triangle; in the whole goal polygon's triangles for G; a disc's sources
  // return a point of the disc.
  Vec2 random_point(Index region, Random& random) const;

  // A point drawn uniformly in the goal.
  Vec2 random_goal_point(Random& random) const;

  // One of the first `count` regions after r on its shortest path, which has so many, each as likely; r where count is
  // 0. O(count).
  Index random_ahead(Index region, Index count, Random& random) const;

 private:
  bool is_goal_triangle(Index triangle) const {
    return goal_region_ != kNone && scene_->goal_of(triangle) == goal_.index();
  }
  Vec2 region_center(Index region) const;
  void find_widest_ways(float reach);
  std::uint8_t edge_to(Index triangle, Index neighbor) const;
  Bottleneck narrowest_on_way(Index from) const;
  Vec2 roomiest_point(Index triangle, int edge) const;
  void set_costs(float least_width);
  void push_sources();
  void run_dijkstra();
  void relax_edges(Index triangle);
  float cost_beside(Index triangle) const;
  bool follows(Index triangle, Index ahead) const;
  Index list_stale();
  void repair_listed(Index count);
  Index list_followers(Index triangle, Index count);
  Index list_if_new(Index triangle, Index count);
  float base_cost(Index a, Index b) const;
  bool marked(Index triangle) const { return (next_[triangle] & kAround) != 0; }
  void raise_around(Index triangle, const CostRaise& raise);
  Index random_goal_triangle(Random& random) const;

  const Scene* scene_ = nullptr;
  Goal goal_ = Goal::named(0);
  Index goal_region_ = kNone;
  Index goal_end_ = 0;      // after the last of its triangles
  float goal_area_ = 0.0F;  // square metres, twice
  Vec2 goal_center_{};
  // The bits of next_: the edge that a triangle's shortest path crosses, and marks.
  static constexpr std::uint8_t kEdgeMask = 3;
  static constexpr std::uint8_t kNoEdge = 3;
  static constexpr std::uint8_t kListed = 4;  // its path is to be recomputed
  static constexpr std::uint8_t kAround = 8;  // one of those whose edges are being raised

  float* h_ = nullptr;
  std::uint8_t* next_ = nullptr;
  float* portal_costs_ = nullptr;
  IndexedHeap heap_;        // between updates the list of the raised
  Index raised_count_ = 0;  // triangles whose edges were raised since h was found
  float largest_ = 0.0F;
  float least_cost_ = 0.0F;  // metres: of an edge
};

}  // namespace krait::detail
