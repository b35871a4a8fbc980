// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/reduce.hpp"

#include <algorithm>
#include <utility>

#include "host/reduce/cells.hpp"
#include "host/reduce/closed.hpp"
#include "host/reduce/corridor.hpp"
#include "host/reduce/crop.hpp"
#include "host/reduce/disc.hpp"
#include "host/reduce/fill.hpp"
#include "host/reduce/goal_cells.hpp"
#include "host/reduce/resample.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

void require_cells(const Workspace& workspace, const char* option) {
  if (workspace.cells) return;
  throw InputError(std::string(option) + ": works on cells, and the map is a drawing: give --cell METRES with it");
}

// Whether a start has a way over free cells, side by side, to a goal.
bool has_way(const CellMap& map, const Workspace& w) {
  const CellFrame frame(map);
  std::vector<std::size_t> seeds;
  for (const Start& start : w.starts) {
    if (const auto cell = cell_at(map, frame, start.position)) seeds.push_back(*cell);
  }
  CellMask free = map.occupied;
  for (std::uint8_t& cell : free) cell = cell == 0;
  const CellMask reached = connected(map, free, seeds);
  return std::any_of(w.goals.begin(), w.goals.end(), [&](const Goal& goal) {
    const std::vector<std::size_t> cells = cells_of(map, goal);
    return std::any_of(cells.begin(), cells.end(), [&](std::size_t cell) { return reached[cell] != 0; });
  });
}

void resample(Workspace& w, double size) {
  if (!w.cells) {
    w.cells = drawn_in_cells(w, size);
    w.obstacles.clear();
    return;
  }
  CellMap larger = resampled(*w.cells, size);
  const std::string option = printed("--cell %.10g", size);
  const std::vector<ClosedPassage> closed = closed_passages(*w.cells, larger);
  if (!closed.empty() && has_way(*w.cells, w) && !has_way(larger, w)) {
    throw InputError(option + printed(" closes every way from the start to the goal, the widest passage that it closes "
                                      "at %.6g,%.6g, some %.3g m wide: take smaller cells",
                                      closed[0].place.x, closed[0].place.y, closed[0].width));
  }
  warn_of_closed(closed, option, w.warnings);
  w.cells = std::move(larger);
}

}  // namespace

Workspace reduced(Workspace workspace, const Reduction& reduction) {
  Workspace w =
      reduction.crop ? cropped(std::move(workspace), reduction.crop->min, reduction.crop->max) : std::move(workspace);
  if (reduction.cell) resample(w, *reduction.cell);
  if (reduction.fill) {
    require_cells(w, "--fill");
    std::vector<Point> starts;
    for (const Start& start : w.starts) starts.push_back(start.position);
    w.cells = filled(*w.cells, *reduction.fill, starts);
    const std::vector<std::uint8_t>& occupied = w.cells->occupied;
    if (std::find(occupied.begin(), occupied.end(), 0) == occupied.end()) {
      throw InputError(
          printed("a disc of radius %.4g m, the robot's or that of --fill, has room nowhere", reduction.fill->inner) +
          (starts.empty() ? "" : " that a start leads to"));
    }
  }
  if (reduction.corridor) {
    require_cells(w, "--corridor");
    w.cells = within_corridor(*w.cells, *reduction.corridor, reduction.disc, w.starts, w.goals, w.warnings);
  }
  return w;
}

}  // namespace krait::host
