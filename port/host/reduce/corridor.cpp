// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/corridor.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "host/reduce/cell_ways.hpp"
#include "host/reduce/cells.hpp"
#include "host/reduce/disc.hpp"
#include "host/reduce/goal_cells.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

// Of the marked cells that a way of at most `most` metres over open cells leads to from one of them, the one whose
// middle is the nearest to the place, of those within `most` metres of it.
std::optional<std::size_t> marked_near(const CellMap& map, const CellMask& open, const CellMask& marked,
                                       std::size_t from, Point world, double most) {
  CellMask around(open.size(), 0);
  each_around(map, world, most, [&](std::size_t cell) { around[cell] = open[cell]; });
  const CellWays ways(map, around, from);
  const Point p = CellFrame(map).cells(world);
  double least = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> best;
  each_around(map, world, most, [&](std::size_t cell) {
    const auto columns = static_cast<std::size_t>(map.columns);
    const double distance = std::hypot(double(cell % columns) + 0.5 - p.x, double(cell / columns) + 0.5 - p.y);
    if (marked[cell] == 0 || !(distance < least) || ways.length_to(cell) > most) return;
    least = distance;
    best = cell;
  });
  return best;
}

// The cells of a goal that are marked; where none is, those within `reach` metres of it that free cells join to it.
std::vector<std::size_t> marked_at(const CellMap& map, const CellMask& marked, const Goal& goal, double reach) {
  std::vector<std::size_t> cells = cells_of(map, goal);
  const auto is_marked = [&](std::size_t cell) { return marked[cell] != 0; };
  if (std::any_of(cells.begin(), cells.end(), is_marked)) return cells;
  CellMask inside(marked.size(), 0);
  for (const std::size_t cell : cells) inside[cell] = 1;
  CellMask near = within_reach(map, inside, reach);
  leave_free(map, near);
  near = connected(map, near, cells);
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (near[i] != 0) cells.push_back(i);
  }
  return cells;
}

// The marked cells and those that are in one block with them, of `size` metres.
CellMask in_blocks(const CellMap& map, CellMask marked, double size) {
  const int side = std::max(1, static_cast<int>(size / map.resolution)), across = (map.columns - 1) / side + 1;
  const auto block = [&](std::size_t cell) {
    const int column = static_cast<int>(cell % static_cast<std::size_t>(map.columns));
    const int row = static_cast<int>(cell / static_cast<std::size_t>(map.columns));
    return static_cast<std::size_t>(row / side * across + column / side);
  };
  CellMask blocks(block(marked.size() - 1) + static_cast<std::size_t>(across), 0);
  for (std::size_t i = 0; i < marked.size(); ++i) blocks[block(i)] |= marked[i];
  for (std::size_t i = 0; i < marked.size(); ++i) marked[i] = blocks[block(i)];
  return marked;
}

// The ways of a disc between the starts and the goals of a map.
class Ways {
 public:
  Ways(const CellMap& map, const Girth& girth, double width)
      : map_(map),
        girth_(girth),
        width_(width),
        free_(free_cells(map)),
        possible_(disc_centers(map, girth.inner, Fit::possible)),
        sure_(disc_centers(map, girth.inner, Fit::sure)),
        on_way_(map.occupied.size(), 0) {}

  const CellMask& on_way() const { return on_way_; }

  // Marks the ways from a start to all goals that it has ways to, and returns which these are.
  std::vector<bool> mark_from(const Start& start, const std::vector<Goal>& goals) {
    std::vector<bool> reached(goals.size(), false);
    const std::optional<std::size_t> own = cell_at(map_, CellFrame(map_), start.position);
    if (!own || free_[*own] == 0) return reached;
    const auto disc = marked_near(map_, free_, possible_, *own, start.position, width_);
    if (!disc) return reached;
    for (const CellMask* centers : {&sure_, &possible_}) {
      if (std::find(reached.begin(), reached.end(), false) == reached.end()) break;
      const auto from = marked_near(map_, possible_, *centers, *disc, start.position, width_);
      if (from) mark(*centers, *from, goals, reached);
    }
    return reached;
  }

 private:
  // Marks the ways over such centers from one of them to the goals that are not reached.
  void mark(const CellMask& centers, std::size_t from, const std::vector<Goal>& goals, std::vector<bool>& reached) {
    const CellWays ways(map_, centers, from);
    for (std::size_t g = 0; g < goals.size(); ++g) {
      const std::size_t to =
          reached[g] ? centers.size() : ways.nearest(marked_at(map_, centers, goals[g], girth_.outer));
      if (to == centers.size()) continue;
      reached[g] = true;
      mark(ways.way_to(to));
    }
  }

  void mark(const std::vector<std::size_t>& way) {
    on_way_[way.front()] = 1;
    for (std::size_t i = 1; i < way.size(); ++i) {
      for (const std::size_t cell : cells_on_line(map_, way[i - 1], way[i])) on_way_[cell] = 1;
    }
  }

  const CellMap& map_;
  const Girth& girth_;
  double width_;
  CellMask free_, possible_, sure_;
  CellMask on_way_;
};

}  // namespace

CellMap within_corridor(const CellMap& map, double width, const Girth& girth, const std::vector<Start>& starts,
                        const std::vector<Goal>& goals, std::vector<std::string>& warnings) {
  const std::string option = printed("--corridor %.10g", width);
  if (starts.empty()) throw InputError(option + ": the map has no start: give --start X,Y,HEADING");
  if (goals.empty()) throw InputError(option + ": the map has no goal: give --goal X,Y,RADIUS");
  if (width < girth.outer) {
    throw InputError(option +
                     printed(": narrower than the robot, whose bodies reach %.4g m from their middles", girth.outer));
  }
  Ways ways(map, girth, width);
  std::vector<bool> reached(goals.size(), false);
  for (const Start& start : starts) {
    const std::vector<bool> from_here = ways.mark_from(start, goals);
    std::transform(reached.begin(), reached.end(), from_here.begin(), reached.begin(), std::logical_or<>());
    if (std::find(from_here.begin(), from_here.end(), true) != from_here.end()) continue;
    throw InputError(option + printed(": a disc of radius %.4g m has no way from start '", girth.inner) + start.name +
                     "' to " + (goals.size() == 1 ? "goal '" + goals[0].name + "'" : "any goal"));
  }
  for (std::size_t g = 0; g < goals.size(); ++g) {
    if (!reached[g]) warnings.push_back(option + ": no way leads to goal '" + goals[g].name + "'");
  }
  return without(map, in_blocks(map, within_reach(map, ways.on_way(), width), width / 2));
}

}  // namespace krait::host
