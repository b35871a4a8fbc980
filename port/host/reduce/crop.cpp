// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/crop.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/reduce/cells.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

bool apart(const Workspace& w, Point min, Point max) {
  return !(min.x < w.max.x && w.min.x < max.x && min.y < w.max.y && w.min.y < max.y);
}

struct Span {
  int first, last;  // one past
};

Span span(double low, double high, int cells) {
  const double first = std::clamp(std::floor(low + kCellRounding), 0.0, double(cells));
  const double last = std::clamp(std::ceil(high - kCellRounding), first, double(cells));
  return {static_cast<int>(first), static_cast<int>(last)};
}

// The columns and rows that meet the box.
CellMap part_of(const CellMap& map, Point min, Point max) {
  const CellFrame frame(map);
  const std::array<Point, 4> corners = {frame.cells(min), frame.cells({max.x, min.y}), frame.cells(max),
                                        frame.cells({min.x, max.y})};
  const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x, corners[3].x});
  const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y, corners[3].y});
  const Span columns = span(left, right, map.columns), rows = span(low, high, map.rows);
  CellMap part{columns.last - columns.first,
               rows.last - rows.first,
               map.resolution,
               frame.world(columns.first, rows.first),
               map.yaw,
               {}};
  for (int row = rows.first; row < rows.last; ++row) {
    const auto first = map.occupied.begin() + std::ptrdiff_t(cell_number(map, columns.first, row));
    part.occupied.insert(part.occupied.end(), first, first + part.columns);
  }
  return part;
}

void require_inside(const Workspace& w, const std::string& crop) {
  for (const Start& s : w.starts) {
    const Point p = s.position;
    if (p.x < w.min.x || p.x > w.max.x || p.y < w.min.y || p.y > w.max.y)
      throw InputError(crop + ": start '" + s.name + "' lies outside: crop a larger part, or give another --start");
  }
  for (const Goal& g : w.goals) {
    Point min = g.polygon.front(), max = min;
    for (const Point p : g.polygon) {
      min = {std::min(min.x, p.x), std::min(min.y, p.y)};
      max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    if (apart(w, min, max)) throw InputError(crop + ": goal '" + g.name + "' lies outside: crop a larger part");
  }
}

}  // namespace

Workspace cropped(Workspace workspace, Point min, Point max) {
  const std::string crop = printed("--crop %.10g,%.10g,%.10g,%.10g", min.x, min.y, max.x, max.y);
  if (apart(workspace, min, max)) {
    throw InputError(crop + printed(": holds nothing of the map, which reaches from %.10g,%.10g to %.10g,%.10g",
                                    workspace.min.x, workspace.min.y, workspace.max.x, workspace.max.y));
  }
  workspace.min = {std::max(workspace.min.x, min.x), std::max(workspace.min.y, min.y)};
  workspace.max = {std::min(workspace.max.x, max.x), std::min(workspace.max.y, max.y)};
  require_inside(workspace, crop);
  if (!workspace.cells) return workspace;
  workspace.cells = part_of(*workspace.cells, workspace.min, workspace.max);
  if (workspace.cells->occupied.empty()) throw InputError(crop + ": holds no cell of the map, which is turned");
  return workspace;
}

}  // namespace krait::host
