// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/snap.hpp"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "host/compiler/cell_index.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host::compiler {
namespace {

__extension__ using Int128 = __int128;

// Rounds up / down / b to the nearest integer, halves upwards; down > 0.
std::int32_t rounded_quotient(Int128 up, Int128 down) {
  const Int128 n = 2 * up + down, d = 2 * down;
  return static_cast<std::int32_t>(n >= 0 ? n / d : -((-n + d - 1) / d));
}

bool cross_properly(const Edge& a, const Edge& b) {
  const auto opposite = [](std::int64_t p, std::int64_t q) { return (p < 0 && q > 0) || (p > 0 && q < 0); };
  return opposite(cross(a.from, a.to, b.from), cross(a.from, a.to, b.to)) &&
         opposite(cross(b.from, b.to, a.from), cross(b.from, b.to, a.to));
}

GridPoint crossing_of(const Edge& a, const Edge& b) {
  Int128 up = cross(b.from, b.to, a.from);
  Int128 down = up - cross(b.from, b.to, a.to);
  if (down < 0) up = -up, down = -down;
  return {a.from.x + rounded_quotient((Int128{a.to.x} - a.from.x) * up, down),
          a.from.y + rounded_quotient((Int128{a.to.y} - a.from.y) * up, down)};
}

// Whether the edge meets the unit square around p, to which of its corners only the lower left one belongs: the squares
// tile the plane, so that edges through a common corner go the same way.
bool meets_pixel(const Edge& e, GridPoint p) {
  const auto [x0, x1] = std::minmax(e.from.x, e.to.x);
  const auto [y0, y1] = std::minmax(e.from.y, e.to.y);
  if (p.x < x0 || p.x > x1 || p.y < y0 || p.y > y1) return false;
  const std::int64_t side = cross(e.from, e.to, p), reach = (std::int64_t{x1} - x0) + (std::int64_t{y1} - y0);
  if (2 * std::abs(side) != reach) return 2 * std::abs(side) < reach;
  // The line touches one corner of the square. It is the lower left one if the line falls and passes below p.
  const bool falls = (e.to.x > e.from.x) != (e.to.y > e.from.y);
  return falls && (side > 0) == (e.to.x > e.from.x) && p.x > x0 && p.y > y0;
}

// One edge a pair of ends, from the smaller to the larger, with the sum of the windings.
void merge_equal(Edges& edges) {
  for (Edge& e : edges) {
    if (e.to < e.from) e = {e.to, e.from, {-e.winding[0], -e.winding[1]}};
  }
  std::erase_if(edges, [](const Edge& e) { return e.from == e.to; });
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
  std::size_t kept = 0;
  for (const Edge& e : edges) {
    if (kept > 0 && edges[kept - 1].from == e.from && edges[kept - 1].to == e.to) {
      edges[kept - 1].winding[0] += e.winding[0];
      edges[kept - 1].winding[1] += e.winding[1];
    } else {
      edges[kept++] = e;
    }
  }
  edges.resize(kept);
}

void sort_unique(std::vector<GridPoint>& points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

bool boxes_meet(const Edge& a, const Edge& b) {
  const auto apart = [](std::int32_t a0, std::int32_t a1, std::int32_t b0, std::int32_t b1) {
    return std::max(a0, a1) < std::min(b0, b1) || std::max(b0, b1) < std::min(a0, a1);
  };
  return !apart(a.from.x, a.to.x, b.from.x, b.to.x) && !apart(a.from.y, a.to.y, b.from.y, b.to.y);
}

class Pass {
 public:
  Pass(const Edges& edges, std::vector<GridPoint> points) : edges_(edges), points_(std::move(points)) {
    for (const Edge& e : edges_) points_.insert(points_.end(), {e.from, e.to});
    sort_unique(points_);
  }

  // The edges led through every end, crossing and point in their way. Counts the crossings.
  Edges run(std::size_t& crossings) {
    const CellIndex index(box_of(points_), edges_.size());
    std::vector<GridPoint> found = find_crossings(index);
    crossings = found.size();
    points_.insert(points_.end(), found.begin(), found.end());
    sort_unique(points_);
    return split(index);
  }

 private:
  std::vector<GridPoint> find_crossings(const CellIndex& index) const {
    const CellLists lists(index.cells(), [&](auto emit) {
      for (std::uint32_t i = 0; i < edges_.size(); ++i) {
        const GridPoint ends[] = {edges_[i].from, edges_[i].to};
        index.near(ends, [&](std::size_t cell) { emit(cell, i); });
      }
    });
    std::vector<GridPoint> found, here;  // each in the cell that it lies in, which both of its edges are in
    for (std::size_t cell = 0; cell < lists.cells(); ++cell) {
      const auto items = lists.at(cell);
      for (std::size_t i = 0; i < items.size(); ++i) {
        for (std::size_t j = i + 1; j < items.size(); ++j) {
          const Edge &a = edges_[items[i]], &b = edges_[items[j]];
          if (!boxes_meet(a, b) || !cross_properly(a, b)) continue;
          const GridPoint crossing = crossing_of(a, b);
          if (index.cell_of(crossing) == cell) here.push_back(crossing);
        }
      }
      sort_unique(here);
      found.insert(found.end(), here.begin(), here.end());
      here.clear();
      if (found.size() > kMaxCrossings) {
        throw InputError("the obstacles cross each other in more than " + std::to_string(kMaxCrossings) +
                         " places: simplify the drawing");
      }
    }
    return found;
  }

  Edges split(const CellIndex& index) const {
    const CellLists lists(index.cells(), [&](auto emit) {
      for (std::uint32_t i = 0; i < points_.size(); ++i) emit(index.cell_of(points_[i]), i);
    });
    Edges result;
    result.reserve(edges_.size());
    std::vector<std::pair<std::int64_t, GridPoint>> stops;
    for (const Edge& e : edges_) {
      stops.clear();
      const GridPoint ends[] = {e.from, e.to};
      index.near(ends, [&](std::size_t cell) {
        for (const std::uint32_t i : lists.at(cell)) {
          if (meets_pixel(e, points_[i])) stops.push_back({dot(e.from, e.to, points_[i]), points_[i]});
        }
      });
      std::sort(stops.begin(), stops.end());
      for (std::size_t i = 1; i < stops.size(); ++i)
        result.push_back({stops[i - 1].second, stops[i].second, e.winding});
    }
    return result;
  }

  const Edges& edges_;
  std::vector<GridPoint> points_;
};

}  // namespace

Snapped snap(Edges edges, const std::vector<GridPoint>& points) {
  Snapped result;
  merge_equal(edges);
  if (edges.empty()) return result;
  constexpr int kMaxPasses = 50;  // two to four in practice
  for (; result.passes < kMaxPasses; ++result.passes) {
    std::size_t crossings = 0;
    Edges split = Pass(edges, points).run(crossings);
    if (crossings == 0 && split.size() == edges.size()) {
      result.edges = std::move(edges);
      return result;
    }
    result.crossings += crossings;
    merge_equal(split);
    edges = std::move(split);
  }
  throw InputError("the obstacles' edges do not come to rest on the scene's grid: simplify the drawing");
}

}  // namespace krait::host::compiler
