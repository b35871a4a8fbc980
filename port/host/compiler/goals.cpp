// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/goals.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "host/compiler/clip.hpp"
#include "host/compiler/snap.hpp"
#include "host/compiler/triangulation.hpp"
#include "krait/format.hpp"

namespace krait::host::compiler {
namespace {

GridRing on_grid(const Goal& goal, const std::string& label, const Frame& frame) {
  check_finite(goal.polygon, label);
  constexpr double kLimit = double(format::kMaxCoordinate) / double(format::kGrid);
  GridRing ring;
  for (const Point world : goal.polygon) {
    const Point p = frame.local(world);
    if (std::abs(p.x) > kLimit || std::abs(p.y) > kLimit) {
      throw InputError(label + " reaches further than " + largest_reach() +
                       " from the middle of the scene: move it or make it smaller");
    }
    const GridPoint q{static_cast<std::int32_t>(std::lround(p.x)), static_cast<std::int32_t>(std::lround(p.y))};
    if (ring.empty() || ring.back() != q) ring.push_back(q);
  }
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

bool simple(const GridRing& ring) {
  Edges edges;
  append_ring(edges, ring, {1, 0});
  GridRing sorted = ring;
  std::sort(sorted.begin(), sorted.end());
  const bool repeats = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  const Snapped snapped = snap(edges);
  return ring.size() >= 3 && !repeats && snapped.passes == 0 && snapped.edges.size() == ring.size() &&
         twice_area(ring) != 0;
}

PlacedGoal place(const Goal& goal, const Frame& frame) {
  const std::string label = "goal '" + goal.name + "'";
  PlacedGoal placed{on_grid(goal, label, frame), {}};
  if (!simple(placed.polygon)) {
    throw InputError(label + " is not a polygon with an area whose edges do not cross or touch: correct its corners");
  }
  if (twice_area(placed.polygon) < 0) std::reverse(placed.polygon.begin(), placed.polygon.end());
  placed.clipped = place_within(goal.polygon, frame);
  if (twice_area(placed.clipped) == 0) throw InputError(label + " lies outside the bounds of the workspace");
  if (twice_area(placed.clipped) < 0) std::reverse(placed.clipped.begin(), placed.clipped.end());
  return placed;
}

// Whether they share more than a strip two grid steps wide.
bool overlap(const GridRing& a, const GridRing& b) {
  Edges edges;
  append_ring(edges, a, {1, 0});
  append_ring(edges, b, {0, 1});
  const Triangulation t = triangulate(snap(edges).edges);
  return std::any_of(t.faces.begin(), t.faces.end(), [&](const Face& face) {
    if (face.winding[0] == 0 || face.winding[1] == 0) return false;
    double longest = 0;
    for (int i = 0; i < 3; ++i) {
      const GridPoint p = t.corner(face, i), q = t.corner(face, i + 1);
      longest = std::max(longest, std::hypot(double(q.x) - p.x, double(q.y) - p.y));
    }
    return double(t.twice_area(face)) > 2 * longest;
  });
}

bool boxes_overlap(const GridBox& a, const GridBox& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

}  // namespace

std::vector<PlacedGoal> place_goals(const Workspace& workspace, const Frame& frame) {
  if (workspace.goals.size() >= format::kNone16) throw InputError("more than 65534 goals: split the scene");
  std::vector<PlacedGoal> goals;
  std::vector<GridBox> boxes;
  for (const Goal& goal : workspace.goals) {
    goals.push_back(place(goal, frame));
    boxes.push_back(box_of(goals.back().clipped));
    for (std::size_t i = 0; i + 1 < goals.size(); ++i) {
      const std::string& other = workspace.goals[i].name;
      if (other == goal.name) throw InputError("two goals are named '" + goal.name + "': rename one");
      if (boxes_overlap(boxes[i], boxes.back()) && overlap(goals[i].clipped, goals.back().clipped)) {
        throw InputError("the goals '" + other + "' and '" + goal.name + "' overlap: move or shrink one");
      }
    }
  }
  return goals;
}

}  // namespace krait::host::compiler
