// SPDX-License-Identifier: Apache-2.0
#include "host/import/shift.hpp"

#include <algorithm>
#include <cmath>

#include "host/input/json.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

constexpr double kMaxReach = 4 * kMaxCoordinate;  // m, of what lies partly or wholly outside the bounds

double reach(const Point& p) { return std::max(std::abs(p.x), std::abs(p.y)); }

// Calls visit(point, label) for every point of the map.
template <class Visit>
void for_each_point(Workspace& workspace, const Visit& visit) {
  visit(workspace.min, "the lower left corner of the bounds");
  visit(workspace.max, "the upper right corner of the bounds");
  if (workspace.cells) visit(workspace.cells->origin, "the map's origin");
  for (Obstacle& obstacle : workspace.obstacles) {
    for (Point& p : obstacle.outer) visit(p, obstacle.label);
    for (Ring& hole : obstacle.holes) {
      for (Point& p : hole) visit(p, obstacle.label);
    }
  }
  for (Goal& goal : workspace.goals) {
    for (Point& p : goal.polygon) visit(p, "goal " + goal.name);
    if (goal.pose) visit(goal.pose->position, "goal " + goal.name);
  }
  for (Start& start : workspace.starts) visit(start.position, "start " + start.name);
}

std::string warning(const std::string& file, const Point& shift) {
  return file + printed(
                    ": lies far from 0: x less %.0f m and y less %.0f m are the coordinates from here on, also of "
                    "starts, goals, plans and pictures",
                    shift.x, shift.y);
}

}  // namespace

void bring_near(const std::string& file, Workspace& workspace, bool warns) {
  if (std::max(reach(workspace.min), reach(workspace.max)) > kMaxCoordinate) {
    const Point shift = {std::round(workspace.min.x / 2 + workspace.max.x / 2),
                         std::round(workspace.min.y / 2 + workspace.max.y / 2)};
    for_each_point(workspace, [&](Point& p, const std::string&) { p = {p.x - shift.x, p.y - shift.y}; });
    workspace.shift = shift;
    if (warns) workspace.warnings.push_back(warning(file, shift));
  }
  for_each_point(workspace, [&](const Point& p, const std::string& label) {
    if (reach(p) <= kMaxReach) return;
    throw InputError(file + ": " + label + ": lies more than " + shown(kMaxReach) +
                     " m from the centre of the map: correct its coordinates");
  });
}

}  // namespace krait::host
