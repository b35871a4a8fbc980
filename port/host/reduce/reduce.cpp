// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
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
  const CellMask reached = connected(map, free_cells(map), seeds);
  return std::any_of(w.goals.begin(), w.goals.end(), [&](const Goal& goal) {
    const std::vector<std::size_t> cells = cells_of(map, goal);
    return std::any_of(cells.begin(), cells.end(), [&](std::size_t cell) { return reached[cell] != 0; });
  });
}

// Of a drawing in cells of that size: one in cells an eighth as large, but of a million at most; nothing where these
// are larger than half of that size, and would show hardly more.
std::optional<CellMap> drawn_finer(const Workspace& drawing, double size) {
  constexpr double kShare = 8, kMost = 1e6;
  const double area = (drawing.max.x - drawing.min.x) * (drawing.max.y - drawing.min.y);
  const double finer = std::max(size / kShare, std::sqrt(area / kMost));
  return finer <= size / 2 ? std::optional(drawn_in_cells(drawing, finer)) : std::nullopt;
}

bool has_free_cell(const CellMap& map) {
  return std::find(map.occupied.begin(), map.occupied.end(), 0) != map.occupied.end();
}

// Warns of the passages that larger cells close, and refuses those that leave no way.
void judge_closed(Workspace& w, const CellMap& before, const CellMap& after, double size) {
  const std::string option = printed("--cell %.10g", size);
  const std::vector<ClosedPassage> closed = closed_passages(before, after);
  if (!closed.empty() && has_way(before, w) && !has_way(after, w)) {
    throw InputError(option + printed(" closes every way from the start to the goal, the widest passage that it closes "
                                      "at %.6g,%.6g, at least %.3g m wide: take smaller cells",
                                      closed[0].place.x, closed[0].place.y, closed[0].width));
  }
  warn_of_closed(closed, option, w.warnings);
}

void resample(Workspace& w, double size) {
  CellMap larger = w.cells ? resampled(*w.cells, size) : drawn_in_cells(w, size);
  const std::optional<CellMap> before = w.cells ? std::move(w.cells) : drawn_finer(w, size);
  if (before) {
    judge_closed(w, *before, larger, size);
  } else {
    w.warnings.push_back(printed("--cell %.10g: the drawing is too large to look for passages that this closes", size));
  }
  if (!has_free_cell(larger) && (!before || has_free_cell(*before)))
    throw InputError(printed("--cell %.10g: leaves no cell free: take smaller cells", size));
  w.cells = std::move(larger);
  w.obstacles.clear();
}

// By goal, whether it has a free cell.
std::vector<bool> open_goals(const Workspace& w) {
  std::vector<bool> open;
  for (const Goal& goal : w.goals) {
    const std::vector<std::size_t> cells = cells_of(*w.cells, goal);
    open.push_back(std::any_of(cells.begin(), cells.end(), [&](std::size_t c) { return w.cells->occupied[c] == 0; }));
  }
  return open;
}

// Names each goal that was open and is not; where no other is left, that is refused.
void judge_goals(Workspace& w, const std::vector<bool>& were_open, const Girth& girth) {
  const std::vector<bool> open = open_goals(w);
  const bool none_left = std::find(open.begin(), open.end(), true) == open.end();
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (open[i] || !were_open[i]) continue;
    const std::string line =
        "goal '" + w.goals[i].name + "' is closed: " +
        (w.starts.empty() ? "it has no room for " : "no way from the starts to it is wide enough for ") +
        printed("a disc of radius %.4g m, the robot's or that of --fill: give a narrower one, or another goal",
                girth.inner);
    if (none_left) throw InputError(line);
    w.warnings.push_back(line);
  }
}

// Why no cell is left free for a disc, by the map before; `larger`: its cells are those of --cell.
std::string why_no_room(const Workspace& w, const Girth& girth, bool larger) {
  const CellFrame frame(*w.cells);
  for (const Start& start : w.starts) {
    const auto cell = cell_at(*w.cells, frame, start.position);
    if (cell && w.cells->occupied[*cell] == 0) continue;
    return "start '" + start.name + printed("' at %.6g,%.6g lies ", start.position.x, start.position.y) +
           (cell ? "in an obstacle" : "outside of the map") + ": give another --start X,Y,HEADING" +
           (cell && larger ? ", or smaller cells to --cell" : "");
  }
  return printed("a disc of radius %.4g m, the robot's or that of --fill, has room nowhere", girth.inner) +
         (w.starts.empty() ? ": give a narrower one" : " that a start leads to: give a narrower one, or another start");
}

void close_for(Workspace& w, const Girth& girth, bool larger) {
  require_cells(w, "--fill");
  std::vector<Point> starts;
  for (const Start& start : w.starts) starts.push_back(start.position);
  const std::vector<bool> open = open_goals(w);
  CellMap closed = filled(*w.cells, girth, starts);
  if (!has_free_cell(closed)) throw InputError(why_no_room(w, girth, larger));
  w.cells = std::move(closed);
  judge_goals(w, open, girth);
}

}  // namespace

Workspace reduced(Workspace workspace, const Reduction& reduction) {
  Workspace w =
      reduction.crop ? cropped(std::move(workspace), reduction.crop->min, reduction.crop->max) : std::move(workspace);
  if (reduction.cell) resample(w, *reduction.cell);
  if (reduction.fill) close_for(w, *reduction.fill, reduction.cell.has_value());
  if (reduction.corridor) {
    require_cells(w, "--corridor");
    w.cells = within_corridor(*w.cells, *reduction.corridor, reduction.disc, w.starts, w.goals, w.warnings);
  }
  return w;
}

}  // namespace krait::host
