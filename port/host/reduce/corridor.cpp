// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/corridor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "host/reduce/cell_ways.hpp"
#include "host/reduce/cells.hpp"
#include "host/reduce/disc.hpp"
#include "host/reduce/goal_cells.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

// The marked cell whose middle is the nearest to the place, of those within `most` metres of it.
std::optional<std::size_t> marked_near(const CellMap& map, const CellMask& marked, Point world, double most) {
  const Point p = CellFrame(map).cells(world);
  double least = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> best;
  each_around(map, world, most, [&](std::size_t cell) {
    const auto columns = static_cast<std::size_t>(map.columns);
    const double distance = std::hypot(double(cell % columns) + 0.5 - p.x, double(cell / columns) + 0.5 - p.y);
    if (marked[cell] == 0 || !(distance < least)) return;
    least = distance;
    best = cell;
  });
  return best;
}

// The cells of a goal that are marked; where none is, those within `reach` metres of it.
std::vector<std::size_t> marked_at(const CellMap& map, const CellMask& marked, const Goal& goal, double reach) {
  std::vector<std::size_t> cells = cells_of(map, goal);
  const auto is_marked = [&](std::size_t cell) { return marked[cell] != 0; };
  if (std::any_of(cells.begin(), cells.end(), is_marked)) return cells;
  CellMask inside(marked.size(), 0);
  for (const std::size_t cell : cells) inside[cell] = 1;
  const CellMask near = within_reach(map, inside, reach);
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
  Ways(const CellMap& map, const Girth& girth, Fit fit)
      : map_(map), girth_(girth), centers_(disc_centers(map, girth.inner, fit)), on_way_(centers_.size(), 0) {}

  const CellMask& on_way() const { return on_way_; }

  // Marks the ways from a start to all goals that it has ways to, and returns whether there is one.
  bool mark_from(const Start& start, const std::vector<Goal>& goals, double most, std::vector<bool>& reached) {
    const auto from = marked_near(map_, centers_, start.position, most);
    if (!from) return false;
    const CellWays ways(map_, centers_, *from);
    bool found = false;
    for (std::size_t g = 0; g < goals.size(); ++g) {
      const std::size_t to = ways.nearest(marked_at(map_, centers_, goals[g], girth_.outer));
      if (to == centers_.size()) continue;
      found = reached[g] = true;
      mark(ways.way_to(to));
    }
    return found;
  }

 private:
  void mark(const std::vector<std::size_t>& way) {
    on_way_[way.front()] = 1;
    for (std::size_t i = 1; i < way.size(); ++i) {
      for (const std::size_t cell : cells_on_line(map_, way[i - 1], way[i])) on_way_[cell] = 1;
    }
  }

  const CellMap& map_;
  const Girth& girth_;
  CellMask centers_;
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
  Ways sure(map, girth, Fit::sure);
  std::optional<Ways> possible;
  std::vector<bool> reached(goals.size(), false);
  for (const Start& start : starts) {
    if (sure.mark_from(start, goals, width, reached)) continue;
    if (!possible) possible.emplace(map, girth, Fit::possible);
    if (possible->mark_from(start, goals, width, reached)) continue;
    throw InputError(option + printed(": a disc of radius %.4g m has no way from start '", girth.inner) + start.name +
                     "' to " + (goals.size() == 1 ? "goal '" + goals[0].name + "'" : "any goal"));
  }
  for (std::size_t g = 0; g < goals.size(); ++g) {
    if (!reached[g]) warnings.push_back(option + ": no way leads to goal '" + goals[g].name + "'");
  }
  CellMask on_way = sure.on_way();
  for (std::size_t i = 0; possible && i < on_way.size(); ++i) on_way[i] |= possible->on_way()[i];
  return without(map, in_blocks(map, within_reach(map, on_way, width), width / 2));
}

}  // namespace krait::host
