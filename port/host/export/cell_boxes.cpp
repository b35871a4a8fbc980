// SPDX-License-Identifier: Apache-2.0
#include "host/export/cell_boxes.hpp"

#include "host/workspace/cell_frame.hpp"

namespace krait::host {
namespace {

struct Run {  // columns from first to before end, from the row `bottom` on
  int first;
  int end;
  int bottom;
};

std::vector<Run> runs_of(const CellMap& cells, int row) {
  std::vector<Run> runs;
  for (int column = 0; column < cells.columns; ++column) {
    if (!cells.at(column, row)) continue;
    if (runs.empty() || runs.back().end != column) runs.push_back({column, column, row});
    runs.back().end = column + 1;
  }
  return runs;
}

Obstacle box(const CellFrame& cells, const Run& run, int top) {
  return {"cells",
          {cells.world(run.first, run.bottom), cells.world(run.end, run.bottom), cells.world(run.end, top),
           cells.world(run.first, top)},
          {}};
}

void add_boxes(const CellMap& cells, std::vector<Obstacle>& obstacles) {
  const CellFrame frame(cells);
  std::vector<Run> open;  // ascending; they may go on in the next row
  for (int row = 0; row <= cells.rows; ++row) {
    std::vector<Run> runs = row < cells.rows ? runs_of(cells, row) : std::vector<Run>();
    std::size_t k = 0;
    for (const Run& before : open) {
      while (k < runs.size() && runs[k].first < before.first) k += 1;
      if (k < runs.size() && runs[k].first == before.first && runs[k].end == before.end) {
        runs[k].bottom = before.bottom;
      } else {
        obstacles.push_back(box(frame, before, row));
      }
    }
    open = std::move(runs);
  }
}

}  // namespace

Point unshifted(const Point& p, const Workspace& workspace) {
  return {p.x + workspace.shift.x, p.y + workspace.shift.y};
}

Ring unshifted(Ring ring, const Workspace& workspace) {
  for (Point& p : ring) p = unshifted(p, workspace);
  return ring;
}

std::vector<Obstacle> all_obstacles(const Workspace& workspace) {
  std::vector<Obstacle> obstacles = workspace.obstacles;
  if (workspace.cells) add_boxes(*workspace.cells, obstacles);
  for (Obstacle& obstacle : obstacles) {
    obstacle.outer = unshifted(std::move(obstacle.outer), workspace);
    for (Ring& hole : obstacle.holes) hole = unshifted(std::move(hole), workspace);
  }
  return obstacles;
}

}  // namespace krait::host
