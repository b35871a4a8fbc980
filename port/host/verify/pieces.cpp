// SPDX-License-Identifier: Apache-2.0
#include "host/verify/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace krait::host {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr double kThin = 1e-12;                 // m
constexpr std::size_t kMostWork = 200'000'000;  // edges looked at in all; some seconds

struct Edge {
  Point low;
  Point high;
  std::size_t ring;  // 0: the outer one

  double x_at(double y) const {
    const double t = (y - low.y) / (high.y - low.y);
    return low.x + t * (high.x - low.x);
  }
};

struct Trapezoid {
  std::size_t left;  // edges
  std::size_t right;
  double bottom;
  double top;
};

void count_work(std::size_t& work, std::size_t amount, const Obstacle& obstacle) {
  work += amount;
  if (work > kMostWork) throw InputError(obstacle.label + ": its outline is too tangled to verify; simplify it");
}

void append_edges(const Ring& ring, std::size_t index, const Obstacle& obstacle, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    if (!std::isfinite(a.x) || !std::isfinite(a.y)) {
      throw InputError(obstacle.label + ": a coordinate is not a finite number");
    }
    if (a.y != b.y) edges.push_back(a.y < b.y ? Edge{a, b, index} : Edge{b, a, index});
  }
}

// From bottom to top.
std::vector<Edge> edges_of(const Obstacle& obstacle) {
  std::vector<Edge> edges;
  append_edges(obstacle.outer, 0, obstacle, edges);
  for (std::size_t i = 0; i < obstacle.holes.size(); ++i) append_edges(obstacle.holes[i], i + 1, obstacle, edges);
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.low.y < b.low.y; });
  return edges;
}

// Appends the height at which two edges cross, if they do.
void append_crossing(const Edge& a, const Edge& b, std::vector<double>& heights) {
  const double bottom = std::max(a.low.y, b.low.y);
  const double top = std::min(a.high.y, b.high.y);
  const double before = a.x_at(bottom) - b.x_at(bottom);
  const double after = a.x_at(top) - b.x_at(top);
  if (before * after < 0) heights.push_back(bottom + (top - bottom) * (before / (before - after)));
}

// Between two of these, no edge begins, ends or crosses another.
std::vector<double> heights_of(const std::vector<Edge>& edges, const Obstacle& obstacle, std::size_t& work) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    heights.push_back(edges[i].low.y);
    heights.push_back(edges[i].high.y);
    const auto [left, right] = std::minmax(edges[i].low.x, edges[i].high.x);
    std::size_t j = i + 1;
    for (; j < edges.size() && edges[j].low.y < edges[i].high.y; ++j) {
      const Edge& other = edges[j];
      if (std::max(other.low.x, other.high.x) < left || std::min(other.low.x, other.high.x) > right) continue;
      append_crossing(edges[i], other, heights);
    }
    count_work(work, j - i, obstacle);
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

Ring corners(const Trapezoid& t, const std::vector<Edge>& edges) {
  const Edge& left = edges[t.left];
  const Edge& right = edges[t.right];
  return {{left.x_at(t.bottom), t.bottom},
          {right.x_at(t.bottom), t.bottom},
          {right.x_at(t.top), t.top},
          {left.x_at(t.top), t.top}};
}

bool is_thin(const Ring& trapezoid) {
  const double height = trapezoid[2].y - trapezoid[1].y;
  const double width = std::max(trapezoid[1].x - trapezoid[0].x, trapezoid[2].x - trapezoid[3].x);
  return height <= kThin || width <= kThin;
}

// Sorts from left to right by insertion: from slab to slab little changes.
void order_at(double y, const std::vector<Edge>& edges, std::vector<std::size_t>& active) {
  std::vector<double> places;
  for (std::size_t i = 0; i < active.size(); ++i) {
    places.push_back(edges[active[i]].x_at(y));
    for (std::size_t j = i; j > 0 && places[j] < places[j - 1]; --j) {
      std::swap(places[j], places[j - 1]);
      std::swap(active[j], active[j - 1]);
    }
  }
}

// Counts, from left to right, in which rings one is.
class Parity {
 public:
  explicit Parity(std::size_t rings) : inside_(rings, false) {}

  void cross(std::size_t ring) {
    inside_[ring] = !inside_[ring];
    if (ring > 0) holes_ += inside_[ring] ? 1 : -1;
  }
  bool filled() const { return inside_[0] && holes_ == 0; }

 private:
  std::vector<bool> inside_;
  int holes_ = 0;
};

}  // namespace

bool inside(const Ring& ring, const Point& point) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
  }
  return odd;
}

std::vector<Ring> convex_pieces(const Obstacle& obstacle) {
  const std::vector<Edge> edges = edges_of(obstacle);
  std::size_t work = 0;
  const std::vector<double> heights = heights_of(edges, obstacle, work);

  std::vector<Trapezoid> trapezoids;
  std::vector<std::size_t> newest(edges.size(), kNone);  // trapezoid to the right of each edge
  std::vector<std::size_t> active;                       // edges that span the slab, left to right
  Parity parity(obstacle.holes.size() + 1);
  std::size_t next_edge = 0;
  for (std::size_t slab = 0; slab + 1 < heights.size(); ++slab) {
    const double bottom = heights[slab];
    const double top = heights[slab + 1];
    std::erase_if(active, [&](std::size_t edge) { return edges[edge].high.y <= bottom; });
    while (next_edge < edges.size() && edges[next_edge].low.y <= bottom) active.push_back(next_edge++);
    order_at(bottom + (top - bottom) / 2, edges, active);
    count_work(work, active.size(), obstacle);

    for (std::size_t i = 0; i < active.size(); ++i) {
      parity.cross(edges[active[i]].ring);
      if (!parity.filled()) continue;
      const std::size_t left = active[i];
      const std::size_t right = active[i + 1];  // a ring that is open is closed by a later edge
      std::size_t& below = newest[left];
      if (below != kNone && trapezoids[below].right == right && trapezoids[below].top == bottom) {
        trapezoids[below].top = top;
      } else {
        below = trapezoids.size();
        trapezoids.push_back({left, right, bottom, top});
      }
    }
  }

  std::vector<Ring> pieces;
  for (const Trapezoid& trapezoid : trapezoids) {
    Ring ring = corners(trapezoid, edges);
    if (!is_thin(ring)) pieces.push_back(std::move(ring));
  }
  return pieces;
}

}  // namespace krait::host
