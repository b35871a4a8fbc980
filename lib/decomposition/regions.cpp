// SPDX-License-Identifier: Apache-2.0
#include "decomposition/regions.hpp"

#include <algorithm>

#include "krait/status.hpp"

namespace krait::detail {
namespace {

constexpr float kExactRatio = 4194304.0F;  // 2^22: where h is below this many times C, h + C is above h in float

Vec2 random_point_in_triangle(const Scene& scene, Index triangle, Random& random) {
  float u = random.unit();
  float v = random.unit();
  if (u + v > 1.0F) {
    u = 1.0F - u;
    v = 1.0F - v;
  }
  const Vec2 a = scene.corner(triangle, 0);
  return a + u * (scene.corner(triangle, 1) - a) + v * (scene.corner(triangle, 2) - a);
}

float double_area(const Scene& scene, Index triangle) {
  const Vec2 a = scene.corner(triangle, 0);
  return cross(scene.corner(triangle, 1) - a, scene.corner(triangle, 2) - a);
}

// Draws by rejection from the square: at most 16 tries, then the centre.
Vec2 random_point_in_disc(Vec2 center, float radius, Random& random) {
  for (int tries = 0; tries < 16; ++tries) {
    const float x = 2.0F * random.unit() - 1.0F;
    const float y = 2.0F * random.unit() - 1.0F;
    if (x * x + y * y <= 1.0F) return center + radius * Vec2{x, y};
  }
  return center;
}

// Eqn 9 in both forms.
void raise_cost(float& cost, float base, const CostRaise& raise) {
  const float least = std::min(raise.length, base);
  const float most = std::max(raise.length, cost);
  cost = cost + (raise.length > 0.0F ? raise.gamma * raise.length * least : raise.gamma) / most;
}

}  // namespace

Regions::Regions() = default;

void Regions::allocate(Arena& arena, const Scene& scene) {
  scene_ = &scene;
  h_ = arena.allocate<float>(Pool::regions, scene.triangle_count());
  next_ = arena.allocate<std::uint8_t>(Pool::regions, scene.triangle_count());
  portal_costs_ = arena.allocate<float>(Pool::portals, scene.portal_count());
  heap_.allocate(arena, Pool::regions, h_, scene.triangle_count());
}

bool Regions::reset(const Goal& goal, float least_width, float least_cost) {
  goal_ = goal;
  goal_region_ = kNone;
  Vec2 weighted{};
  goal_area_ = 0.0F;
  bool found = false;
  for (Index t = 0; t < scene_->triangle_count(); ++t) {
    if (!goal.covers(*scene_, t)) continue;
    if (!found && !goal.is_disc()) goal_region_ = t;
    goal_end_ = t + 1;
    found = true;
    const float area = double_area(*scene_, t);
    weighted = weighted + area * scene_->centroid(t);
    goal_area_ += area;
  }
  if (!found) return false;
  goal_center_ = goal.is_disc() ? goal.center() : (1.0F / goal_area_) * weighted;
  least_cost_ = least_cost;
  set_costs(least_width);
  update();
  return true;
}

bool Regions::connected(Index from, const Goal& goal, float reach, float least_width) {
  for (Index t = 0; t < scene_->triangle_count(); ++t) h_[t] = kInfinity;
  const Box box = goal.box(*scene_);
  Index found = 0;
  const auto visit = [&](Index triangle) {
    h_[triangle] = 0.0F;
    heap_.list(found++, triangle);
  };
  visit(from);
  for (Index i = 0; i < found; ++i) {
    const Index triangle = heap_.listed(i);
    if (goal.may_reach(*scene_, triangle, reach, box)) return true;
    for (int edge = 0; edge < 3; ++edge) {
      const Index n = scene_->neighbor(triangle, edge);
      if (n == kNone || h_[n] == 0.0F) continue;
      if (scene_->portal_width(scene_->portal(triangle, edge)) >= least_width) visit(n);
    }
  }
  return false;
}

Bottleneck Regions::widest_way(Index from, float reach) {
  find_widest_ways(reach);
  const Bottleneck narrowest = narrowest_on_way(from);
  update();
  return narrowest;
}

// Dijkstra with the width of a way in place of its length: h is minus the width of the widest way to the goal, and
// next_ the edge that it crosses first.
void Regions::find_widest_ways(float reach) {
  heap_.reset();
  const Box box = goal_.box(*scene_);
  for (Index t = 0; t < scene_->triangle_count(); ++t) {
    const bool source = reach > 0.0F ? goal_.may_reach(*scene_, t, reach, box) : goal_.covers(*scene_, t);
    h_[t] = source ? -kInfinity : 0.0F;
    next_[t] = kNoEdge;
    if (source) heap_.push(t);
  }
  while (!heap_.empty()) {
    const Index triangle = heap_.pop();
    for (int edge = 0; edge < 3; ++edge) {
      const Index n = scene_->neighbor(triangle, edge);
      if (n == kNone) continue;
      const float portal = -scene_->portal_width(scene_->portal(triangle, edge));
      const float through = std::max(portal, h_[triangle]);
      if (!(through < h_[n])) continue;
      h_[n] = through;
      next_[n] = edge_to(n, triangle);
      heap_.push(n);
    }
  }
}

// The edge that the triangle shares with its neighbour.
std::uint8_t Regions::edge_to(Index triangle, Index neighbor) const {
  std::uint8_t edge = 0;
  while (edge < 2 && scene_->neighbor(triangle, edge) != neighbor) ++edge;
  return edge;
}

// The first portal on the widest way that is as narrow as the way.
Bottleneck Regions::narrowest_on_way(Index from) const {
  Bottleneck narrowest;
  if (h_[from] == 0.0F) return narrowest;
  narrowest.width = -h_[from];
  Index triangle = from;
  for (std::uint8_t edge = next_[triangle]; edge != kNoEdge; edge = next_[triangle]) {
    if (scene_->portal_width(scene_->portal(triangle, edge)) == narrowest.width) {
      narrowest.at = roomiest_point(triangle, edge);
      break;
    }
    triangle = scene_->neighbor(triangle, edge);
  }
  return narrowest;
}

// The point of the edge with the most clearance by the grid, of some points; the middle where none has more.
Vec2 Regions::roomiest_point(Index triangle, int edge) const {
  constexpr int kPoints = 8;  // on each side of the middle
  const Vec2 a = scene_->corner(triangle, edge);
  const Vec2 half = 0.5F * (scene_->corner(triangle, (edge + 1) % 3) - a);
  const Vec2 middle = a + half;
  Vec2 best = middle;
  for (int i = 1 - kPoints; i < kPoints; ++i) {
    const Vec2 point = middle + (static_cast<float>(i) / kPoints) * half;
    if (scene_->clearance().at(point) > scene_->clearance().at(best)) best = point;
  }
  return best;
}

Vec2 Regions::region_center(Index region) const {
  return region == goal_region_ ? goal_center_ : scene_->centroid(region);
}

void Regions::set_costs(float least_width) {
  for (Index t = 0; t < scene_->triangle_count(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Index n = scene_->neighbor(t, i);
      if (n == kNone || n < t) continue;
      const Index portal = scene_->portal(t, i);
      const bool passable = scene_->portal_width(portal) >= least_width;
      portal_costs_[portal] = passable ? base_cost(region(t), region(n)) : kInfinity;
    }
  }
}

// C0: how far apart the centres of two regions are, but at least the least cost.
float Regions::base_cost(Index a, Index b) const {
  const float apart = length(region_center(b) - region_center(a));
  return std::max(least_cost_, apart);
}

void Regions::push_sources() {
  heap_.reset();
  raised_count_ = 0;
  for (Index t = 0; t < scene_->triangle_count(); ++t) {
    const bool source = goal_.covers(*scene_, t);
    h_[t] = source ? 0.0F : kInfinity;
    next_[t] = kNoEdge;
    if (source) heap_.push(t);
  }
}

void Regions::update() {
  push_sources();
  largest_ = 0.0F;
  run_dijkstra();
}

// Until the heap is empty.
void Regions::run_dijkstra() {
  while (!heap_.empty()) {
    const Index triangle = heap_.pop();
    if (h_[triangle] > largest_) largest_ = h_[triangle];
    relax_edges(triangle);
  }
}

// Finds what comes next on the triangle's path, the edge to argmin over the neighbours of (h + C, region), a pure
// function of h and C: who is further from the goal cannot come next. And relaxes the edges to those that are. Where h
// is so large that h + C is h, of those as far from the goal only one whose path was found before can come next: every
// path ends in the goal.
[[gnu::flatten]] void Regions::relax_edges(Index triangle) {
  const float distance = h_[triangle];
  std::uint8_t best = kNoEdge;
  float least = distance > 0.0F ? kInfinity : -kInfinity;  // a goal has no next
  Index best_neighbor = kNone;
  for (std::uint8_t edge = 0; edge < 3; ++edge) {
    const Index n = scene_->neighbor(triangle, edge);
    if (n == kNone) continue;
    const float cost = portal_costs_[scene_->portal(triangle, edge)];
    if (h_[n] > distance) {
      if (distance + cost < h_[n]) {
        h_[n] = distance + cost;
        heap_.push(n);
      }
      continue;
    }
    if (h_[n] == distance && (next_[n] & kEdgeMask) == kNoEdge) continue;
    const float back = h_[n] + cost;
    if (back == kInfinity || back > least) continue;
    if (back == least && region(n) >= region(best_neighbor)) continue;
    least = back;
    best = edge;
    best_neighbor = n;
  }
  next_[triangle] = best;
}

// A raised edge lengthens the paths that cross it: those of the raised region, whose every edge rose, and of all that
// follow it in the shortest-path tree. They are recomputed from the neighbours that do not; no other path can have
// changed. So Ramalingam and Reps (Journal of Algorithms 21, 1996) repair paths where edges have become longer. Where h
// has grown so large that h + C may be h, paths depend on the order of Dijkstra's queue: then all are recomputed.
Index Regions::repair(bool all) {
  const Index stale = list_stale();
  if (!all) repair_listed(stale);
  const float exact_below = kExactRatio * least_cost_;
  if (all || largest_ >= exact_below) update();
  return largest_ < exact_below ? stale : scene_->triangle_count();
}

void Regions::repair_listed(Index count) {
  for (Index i = 0; i < count; ++i) {
    const Index triangle = heap_.listed(i);
    if (h_[triangle] > 0.0F) h_[triangle] = cost_beside(triangle);
  }
  for (Index i = 0; i < count; ++i) {
    const Index triangle = heap_.listed(i);
    next_[triangle] = kNoEdge;
    if (h_[triangle] < kInfinity) heap_.push(triangle);
  }
  raised_count_ = 0;
  run_dijkstra();
}

// The shortest path that goes on to a region whose own is not to be recomputed.
float Regions::cost_beside(Index triangle) const {
  float least = kInfinity;
  for (int edge = 0; edge < 3; ++edge) {
    const Index n = scene_->neighbor(triangle, edge);
    if (n == kNone || (next_[n] & kListed) != 0) continue;
    const float through = h_[n] + portal_costs_[scene_->portal(triangle, edge)];
    if (through < least) least = through;
  }
  return least;
}

bool Regions::follows(Index triangle, Index ahead) const {
  const std::uint8_t edge = next_[triangle] & kEdgeMask;
  return edge != kNoEdge && scene_->neighbor(triangle, edge) == ahead;
}

Index Regions::list_stale() {
  Index count = raised_count_;
  for (Index i = 0; i < count; ++i) count = list_followers(heap_.listed(i), count);
  return count;
}

Index Regions::list_followers(Index triangle, Index count) {
  for (int edge = 0; edge < 3; ++edge) {
    const Index n = scene_->neighbor(triangle, edge);
    if (n != kNone && follows(n, triangle)) count = list_if_new(n, count);
  }
  return count;
}

Index Regions::list_if_new(Index triangle, Index count) {
  if ((next_[triangle] & kListed) != 0) return count;
  next_[triangle] |= kListed;
  heap_.list(count, triangle);
  return count + 1;
}

void Regions::raise_edges(Index region, const CostRaise& raise) {
  KRAIT_ASSERT(region < scene_->triangle_count());
  if (region != goal_region_) {
    raise_around(region, raise);
    return;
  }
  for (Index t = goal_region_; t < goal_end_; ++t) {
    if (is_goal_triangle(t)) raise_around(t, raise);
  }
}

// Breadth first. A region is marked once it is among those around, or is never: an edge between two of them rises with
// the one of the smaller number.
void Regions::raise_around(Index triangle, const CostRaise& raise) {
  const float reach = is_goal(triangle) ? 0.0F : kRaiseReach * raise.length;
  Index around[kMostRaised];
  around[0] = triangle;
  Index count = 1;
  next_[triangle] |= kAround;
  for (Index i = 0; i < count; ++i) {
    const Index t = around[i];
    const Index here = region(t);
    raised_count_ = list_if_new(t, raised_count_);
    for (int edge = 0; edge < 3; ++edge) {
      const Index n = scene_->neighbor(t, edge);
      if (n == kNone) continue;
      const Index there = region(n);
      if (there == here) continue;
      float& cost = portal_costs_[scene_->portal(t, edge)];
      if (count < kMostRaised && cost < kInfinity && !marked(n) && !is_goal(there) && base_cost(triangle, n) < reach) {
        next_[n] |= kAround;
        around[count++] = n;
      }
      if (n > t || !marked(n)) raise_cost(cost, base_cost(here, there), raise);
    }
  }
  for (Index i = 0; i < count; ++i) next_[around[i]] &= kEdgeMask | kListed;
}

Index Regions::random_goal_triangle(Random& random) const {
  float remaining = random.unit() * goal_area_;
  Index chosen = goal_region_;
  for (Index t = goal_region_; t < goal_end_ && remaining >= 0.0F; ++t) {
    if (!is_goal_triangle(t)) continue;
    remaining -= double_area(*scene_, t);
    chosen = t;
  }
  return chosen;
}

Vec2 Regions::random_goal_point(Random& random) const {
  if (goal_.is_disc()) return random_point_in_disc(goal_.center(), goal_.radius(), random);
  const Index triangle = random_goal_triangle(random);
  return random_point_in_triangle(*scene_, triangle, random);
}

Vec2 Regions::random_point(Index region, Random& random) const {
  return is_goal(region) ? random_goal_point(random) : random_point_in_triangle(*scene_, region, random);
}

Index Regions::next(Index r) const {
  const std::uint8_t edge = next_[r] & kEdgeMask;
  return edge == kNoEdge ? kNone : region(scene_->neighbor(r, edge));
}

Index Regions::regions_ahead(Index region, Index most, float distance) const {
  const Vec2 from = region_center(region);
  Index count = 0;
  for (Index r = next(region); r != kNone && (count < most || count < kMostAhead); r = next(r)) {
    if (count >= most && length(region_center(r) - from) >= distance) break;
    ++count;
  }
  return count;
}

Index Regions::random_ahead(Index region, Index count, Random& random) const {
  KRAIT_ASSERT(region < scene_->triangle_count());
  if (count == 0) return region;
  for (std::uint32_t steps = 1 + random.below(count); steps > 0; --steps) region = next(region);
  return region;
}

}  // namespace krait::detail
