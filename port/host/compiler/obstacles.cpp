// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "host/compiler/cells.hpp"
#include "host/compiler/clip.hpp"
#include "host/compiler/rings.hpp"
#include "host/compiler/snap.hpp"
#include "host/compiler/unite.hpp"
#include "host/workspace/cell_frame.hpp"
#include "host/workspace/printed.hpp"
#include "krait/format.hpp"

namespace krait::host::compiler {
namespace {

// A point stays an obstacle: one grid step wide.
GridRing square_at(GridPoint p, const GridBox& bounds) {
  const GridPoint min{std::min(p.x, bounds.max.x - 1), std::min(p.y, bounds.max.y - 1)};
  return ring_of({min, {min.x + 1, min.y + 1}});
}

bool has_area(const Ring& ring) {
  std::set<std::pair<double, double>> distinct;
  for (const Point p : ring) distinct.insert({p.x, p.y});
  if (distinct.size() < 3) return false;
  const Point a = ring.front();
  Point far = a;
  for (const Point p : ring) {
    if (std::hypot(p.x - a.x, p.y - a.y) > std::hypot(far.x - a.x, far.y - a.y)) far = p;
  }
  const double length = std::hypot(far.x - a.x, far.y - a.y);
  return std::any_of(ring.begin(), ring.end(), [&](Point p) {
    return std::abs((far.x - a.x) * (p.y - a.y) - (far.y - a.y) * (p.x - a.x)) > 1e-9 * length * length;
  });
}

// The longest of the edges that an outline and a hole in it have in common, but for those along the bounds, which are
// a wall in any case. Edges as snap() returns them.
std::optional<Edge> open_edge(const Edges& edges, const GridBox& bounds) {
  const auto length = [](const Edge& e) { return dot(e.from, e.to, e.to); };
  std::optional<Edge> longest;
  for (const Edge& e : edges) {
    const bool common = e.winding[0] != 0 && e.winding[1] != 0 && !on_border(e, bounds);
    if (common && (!longest || length(e) > length(*longest))) longest = e;
  }
  return longest;
}

class Collector {
 public:
  Collector(const Frame& frame, std::vector<std::string>& warnings) : frame_(frame), warnings_(warnings) {}

  void add(const Obstacle& obstacle) {
    check_finite(obstacle.outer, obstacle.label);
    for (const Ring& hole : obstacle.holes) check_finite(hole, obstacle.label);
    if (obstacle.outer.empty()) throw InputError(obstacle.label + " has no points: give at least 3, or remove it");
    if (!has_area(obstacle.outer)) {
      warnings_.push_back(obstacle.label + " has no area: taken as a wall as thin as the scene's grid, 0.25 mm");
    }
    GridRing outer = place_within(obstacle.outer, frame_);
    if (outer.empty()) return;
    if (outer.size() == 1) outer = square_at(outer.front(), frame_.bounds);
    Edges edges;
    append_ring(edges, outer, {1, 0});
    for (const Ring& hole : obstacle.holes) append_ring(edges, place_within(hole, frame_), {0, 1});
    const Snapped snapped = snap(edges);
    if (snapped.crossings > 0) {
      warnings_.push_back(
          obstacle.label +
          " crosses itself: what its outline goes around counts as solid, but for what a hole goes around");
    }
    const bool plain = obstacle.holes.empty() && snapped.passes == 0 && snapped.edges.size() == outer.size() &&
                       std::set<GridPoint>(outer.begin(), outer.end()).size() == outer.size();
    if (plain) {
      if (twice_area(outer) < 0) std::reverse(outer.begin(), outer.end());
      parts_.emplace_back();
      append_ring(parts_.back(), outer, {1, 0});
    } else {
      if (!add_tangle({std::move(edges)}))
        warnings_.push_back(obstacle.label + " is no obstacle: its holes leave nothing of it");
      else if (const auto open = open_edge(snapped.edges, frame_.bounds))
        warn_of_open(*open, obstacle.label);
    }
  }

  void add(const CellMap& map) {
    if (!(map.resolution > 0) || map.columns <= 0 || map.rows <= 0) throw InputError("the map has no cells");
    if (map.occupied.size() != static_cast<std::size_t>(map.rows) * static_cast<std::size_t>(map.columns)) {
      throw InputError("the map's cells are not rows times columns");
    }
    const CellFrame cells(map);
    const double columns = map.columns, rows = map.rows;
    const Ring frame_ring{cells.world(0, 0), cells.world(columns, 0), cells.world(columns, rows), cells.world(0, rows)};
    check_finite(frame_ring, "the map");
    if (map.resolution < 3 * double(format::kGrid)) {
      throw InputError("the map's cells are smaller than 0.75 mm: scale its resolution");
    }
    const GridBox& b = frame_.bounds;
    const auto on_grid = [&](int column, int row) { return frame_.nearest(cells.world(column, row)); };
    Edges edges = outline(map, on_grid);
    const bool inside =
        std::all_of(edges.begin(), edges.end(), [&](const Edge& e) { return within(e.from, b) && within(e.to, b); });
    if (inside) {
      parts_.push_back(std::move(edges));
    } else {
      add_clipped(std::move(edges));
    }
    add_outside(frame_ring);
  }

  Solid united() && {
    const bool sound = parts_.size() == 1 && tangles_ == 0;
    if (sound) return {std::move(parts_.front()), 1};
    United united = unite(std::move(parts_), frame_.bounds);
    return {std::move(united.boundary), 1 + most_passes_ + united.passes};
  }

 private:
  void warn_of_open(const Edge& edge, const std::string& label) {
    const Point from = frame_.world(edge.from), to = frame_.world(edge.to);
    warnings_.push_back(label + printed(" has a hole along its outline, from %.6g,%.6g to %.6g,%.6g: no wall is left "
                                        "there; move the hole inwards where there is one",
                                        from.x, from.y, to.x, to.y));
  }

  // Whether anything of it is solid.
  bool add_tangle(std::vector<Edges> edges) {
    United part = unite(std::move(edges), frame_.bounds);
    most_passes_ = std::max(most_passes_, part.passes);
    ++tangles_;
    if (part.boundary.empty()) return false;
    parts_.push_back(std::move(part.boundary));
    return true;
  }

  // The part within the bounds of a map that was cropped.
  void add_clipped(Edges edges) {
    Edges clipped;
    for (const GridRing& ring : rings_of(std::move(edges)))
      append_ring(clipped, clip_within(ring, frame_.bounds), {1, 0});
    if (!clipped.empty()) add_tangle({std::move(clipped)});
  }

  // Within the bounds, but not on the map.
  void add_outside(const Ring& map_frame) {
    GridRing hole;
    for (const Point p : map_frame) hole.push_back(frame_.nearest(p));
    const bool inside = std::all_of(hole.begin(), hole.end(), [&](GridPoint p) { return within(p, frame_.bounds); });
    if (!inside) hole = place_within(map_frame, frame_);
    if (hole == ring_of(frame_.bounds)) return;
    Edges edges;
    append_ring(edges, ring_of(frame_.bounds), {1, 0});
    append_ring(edges, hole, {0, 1});
    add_tangle({std::move(edges)});
  }

  const Frame& frame_;
  std::vector<std::string>& warnings_;
  std::vector<Edges> parts_;
  int most_passes_ = 0;
  int tangles_ = 0;
};

}  // namespace

Solid solid_of(const Workspace& workspace, const Frame& frame, std::vector<std::string>& warnings) {
  Collector collector(frame, warnings);
  for (const Obstacle& obstacle : workspace.obstacles) collector.add(obstacle);
  if (workspace.cells) collector.add(*workspace.cells);
  return std::move(collector).united();
}

}  // namespace krait::host::compiler
