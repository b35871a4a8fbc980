// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/simplify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <queue>

#include "host/compiler/cell_index.hpp"
#include "host/compiler/lipschitz.hpp"
#include "host/compiler/passages.hpp"

namespace krait::host::compiler {
namespace {

constexpr std::uint32_t kLongestChain = 2000;  // vertices that one straight line may replace

double distance(double x, double y, GridPoint a, GridPoint b) {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y;
  const double t = std::clamp(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - a.x - t * dx, y - a.y - t * dy);
}

// The places of Kept, by cell.
class KeptPlaces {
 public:
  KeptPlaces(const std::vector<GridPoint>& places, double reach)
      : places_(places),
        reach_(reach),
        index_(places.empty() ? GridBox{} : box_of(places), places.size()),
        lists_(index_.cells(), [&](auto emit) {
          for (std::uint32_t i = 0; i < places.size(); ++i) emit(index_.cell_of(places[i]), i);
        }) {}

  // Whether the segment comes within reach of one.
  bool near(GridPoint a, GridPoint b) const {
    const auto reach = static_cast<std::int32_t>(std::ceil(reach_));
    const GridPoint low{std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach};
    const GridPoint high{std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach};
    bool found = false;
    index_.near(std::array{low, GridPoint{high.x, low.y}, high, GridPoint{low.x, high.y}}, [&](std::size_t cell) {
      const auto here = lists_.at(cell);
      found = found || std::any_of(here.begin(), here.end(), [&](std::uint32_t i) {
                return distance(places_[i].x, places_[i].y, a, b) < reach_;
              });
    });
    return found;
  }

 private:
  const std::vector<GridPoint>& places_;
  double reach_;
  CellIndex index_;
  CellLists lists_;
};

class Simplifier {
 public:
  // What becomes solid, or free, lies within twice the growth, and a step, of a segment of the new outline.
  Simplifier(const std::vector<GridRing>& rings, double growth, double narrow, const Kept& kept)
      : growth_(growth),
        kept_(kept.places, kept.reach + 2 * growth + 1),
        passages_(narrow > 0 ? rings : std::vector<GridRing>{}, narrow + growth) {
    for (const GridRing& ring : rings) {
      const auto first = static_cast<std::uint32_t>(points_.size());
      const auto size = static_cast<std::uint32_t>(ring.size());
      for (std::uint32_t i = 0; i < size; ++i) {
        points_.push_back(ring[i]);
        nodes_.push_back({first + (i + size - 1) % size, first + (i + 1) % size, first, size, true});
      }
      left_.resize(points_.size(), size);
    }
  }

  std::vector<GridRing> run() {
    if (points_.empty()) return {};
    const CellIndex index(box_of(points_), points_.size());
    const CellLists lists(index.cells(), [&](auto emit) {
      for (std::uint32_t i = 0; i < points_.size(); ++i) emit(index.cell_of(points_[i]), i);
    });
    for (std::uint32_t i = 0; i < points_.size(); ++i) push(i);
    while (!queue_.empty()) {
      const Candidate c = queue_.top();
      queue_.pop();
      const Node& node = nodes_[c.node];
      if (!node.alive || c.previous != node.previous || c.next != node.next) continue;
      if (removable(c.node, index, lists)) remove(c.node);
    }
    return remaining();
  }

 private:
  struct Node {
    std::uint32_t previous, next;
    std::uint32_t ring_first, ring_size;
    bool alive;
  };
  struct Candidate {
    std::int64_t area;
    std::uint32_t node, previous, next;
    bool operator<(const Candidate& o) const { return area != o.area ? area > o.area : node > o.node; }
  };

  void push(std::uint32_t i) {
    const Node& n = nodes_[i];
    const std::int64_t area = cross(points_[n.previous], points_[i], points_[n.next]);
    const double base = std::sqrt(double(dot(points_[n.previous], points_[n.next], points_[n.next])));
    if (growth_ <= 0 ? area != 0 : double(-area) > kShrink * base) return;
    queue_.push({std::abs(area), i, n.previous, n.next});
  }

  bool removable(std::uint32_t i, const CellIndex& index, const CellLists& lists) const {
    const Node& n = nodes_[i];
    if (left_[n.ring_first] <= 3 || points_[n.previous] == points_[n.next]) return false;
    return (is_straight(i) || !kept_.near(points_[n.previous], points_[n.next])) && within_growth(n) &&
           triangle_is_empty(i, index, lists) && !narrows(i);
  }

  bool is_straight(std::uint32_t i) const {
    return cross(points_[nodes_[i].previous], points_[i], points_[nodes_[i].next]) == 0;
  }

  // The original vertices from node a to node b, by index.
  template <class Visit>
  bool all_of_chain(std::uint32_t a, std::uint32_t b, Visit visit) const {
    const Node& n = nodes_[a];
    for (std::uint32_t i = a; i != b;) {
      const std::uint32_t next = i + 1 == n.ring_first + n.ring_size ? n.ring_first : i + 1;
      if (!visit(points_[i], points_[next])) return false;
      i = next;
    }
    return true;
  }

  bool within_growth(const Node& n) const {
    const GridPoint a = points_[n.previous], b = points_[n.next];
    const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
    const std::uint32_t size = nodes_[n.previous].ring_size;
    if ((n.next + size - n.previous) % size > kLongestChain) return false;
    const double shrink = growth_ > 0 ? kShrink : 0;
    const bool sides = all_of_chain(n.previous, n.next, [&](GridPoint p, GridPoint) {
      const double out = double(cross(a, b, p));  // positive: solid there becomes free
      if (out > shrink * length || -out > (2 * growth_ + 1) * length) return false;
      const std::int64_t along = dot(a, b, p);
      const bool beside = along >= 0 && along <= dot(a, b, b);
      return beside || distance(p.x, p.y, a, b) <= shrink;  // a spike past an end would be cut off
    });
    return sides && (growth_ <= 0 || near_chain(n));
  }

  // Whether no point of the line that replaces a chain is further than the growth, and a thousandth of it, from the
  // chain. No point that an edge of the chain is beside is further from this edge than straight across: the distance is
  // sampled only where that is too far.
  bool near_chain(const Node& n) const {
    const double slack = growth_ / 1000, most = growth_ + slack;
    const GridPoint a = points_[n.previous], b = points_[n.next];
    const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
    const auto gap = [&](double t) {
      const double x = a.x + (double(b.x) - a.x) * t / length, y = a.y + (double(b.y) - a.y) * t / length;
      double nearest = 1e18;
      all_of_chain(n.previous, n.next, [&](GridPoint p, GridPoint q) {
        nearest = std::min(nearest, distance(x, y, p, q));
        return true;
      });
      return nearest;
    };
    const auto near_between = [&](double from, double to) {
      const auto [low, high] = std::minmax({std::clamp(from, 0.0, length), std::clamp(to, 0.0, length)});
      return never_exceeds(gap, low, high, growth_, slack);
    };
    return all_of_chain(n.previous, n.next, [&](GridPoint p, GridPoint q) {
      const double from = double(dot(a, b, p)) / length, to = double(dot(a, b, q)) / length;
      for (const double side : {-1.0, 1.0}) {
        const double at_p = side * double(cross(a, b, p)) / length - most;  // positive: too far on this side
        const double at_q = side * double(cross(a, b, q)) / length - most;
        if (at_p <= 0 && at_q <= 0) continue;
        const double border = from + (to - from) * at_p / (at_p - at_q);
        if (!near_between(at_p > 0 ? from : border, at_q > 0 ? to : border)) return false;
      }
      return true;
    });
  }

  // Obstacles on both sides of a passage may grow: the passages' own edges are those that have not.
  bool narrows(std::uint32_t i) const {
    const GridPoint a = points_[nodes_[i].previous], b = points_[nodes_[i].next];
    return cross(a, points_[i], b) > 0 && passages_.narrow(a, b);
  }

  // No vertex lies in the closed triangle but its own three. Where another ring touches the vertex, its going must not
  // part them.
  bool triangle_is_empty(std::uint32_t i, const CellIndex& index, const CellLists& lists) const {
    const GridPoint t[] = {points_[nodes_[i].previous], points_[i], points_[nodes_[i].next]};
    const std::int64_t area = cross(t[0], t[1], t[2]);
    const std::int64_t sign = area < 0 ? -1 : 1;
    bool empty = true;
    index.near(t, [&](std::size_t cell) {
      if (!empty) return;
      for (const std::uint32_t k : lists.at(cell)) {
        if (!nodes_[k].alive || k == i) continue;
        const GridPoint p = points_[k];
        if (p == t[0] || p == t[2]) continue;
        if (p == t[1]) {
          if (area <= 0) empty = false;
          continue;
        }
        if (area == 0 ? cross(t[0], t[2], p) == 0 && dot(p, t[0], t[2]) <= 0
                      : sign * cross(t[0], t[1], p) >= 0 && sign * cross(t[1], t[2], p) >= 0 &&
                            sign * cross(t[2], t[0], p) >= 0) {
          empty = false;
        }
      }
    });
    return empty;
  }

  void remove(std::uint32_t i) {
    Node& n = nodes_[i];
    n.alive = false;
    --left_[n.ring_first];
    nodes_[n.previous].next = n.next;
    nodes_[n.next].previous = n.previous;
    push(n.previous);
    push(n.next);
  }

  std::vector<GridRing> remaining() const {
    std::vector<GridRing> rings;
    for (std::uint32_t first = 0; first < nodes_.size(); first += nodes_[first].ring_size) {
      GridRing ring;
      for (std::uint32_t i = first; i < first + nodes_[first].ring_size; ++i) {
        if (nodes_[i].alive) ring.push_back(points_[i]);
      }
      rings.push_back(std::move(ring));
    }
    return rings;
  }

  double growth_;
  KeptPlaces kept_;
  Passages passages_;
  std::vector<GridPoint> points_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> left_;  // by a ring's first node: how many of its nodes are alive
  std::priority_queue<Candidate> queue_;
};

}  // namespace

std::vector<GridRing> simplify(const std::vector<GridRing>& rings, double growth, double narrow, const Kept& kept) {
  return Simplifier(rings, growth, narrow, kept).run();
}

}  // namespace krait::host::compiler
