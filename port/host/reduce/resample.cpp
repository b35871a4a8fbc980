// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/resample.hpp"

#include <algorithm>
#include <cmath>

#include "host/reduce/cells.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

std::string option(double size) { return printed("--cell %.10g", size); }

// Whole cells of a length of `cells` old ones.
int whole(double cells) { return static_cast<int>(std::floor(cells + kCellRounding)); }

// An empty map of as many whole cells as the lengths hold.
CellMap empty_map(double width, double height, double size, Point origin, double yaw) {
  const double columns = std::floor(width / size + kCellRounding), rows = std::floor(height / size + kCellRounding);
  if (columns < 1 || rows < 1)
    throw InputError(option(size) + printed(": the map is only %.10g m by %.10g m", width, height));
  if (columns * rows > kMostCells) {
    throw InputError(option(size) +
                     printed(": makes %.0f by %.0f cells, more than 64 million: take larger ones", columns, rows));
  }
  CellMap map{static_cast<int>(columns), static_cast<int>(rows), size, origin, yaw, {}};
  map.occupied.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows), 0);
  return map;
}

// New cells that an old one meets: `factor` old ones are a new one.
struct Range {
  int first, last;
};

Range met_by(int old, double factor, int cells) {
  const int first = whole(old / factor), last = static_cast<int>(std::ceil((old + 1) / factor - kCellRounding)) - 1;
  return {first, std::min(last, cells - 1)};
}

// Marks the cells of a drawing's rings, in cells.
class Painter {
 public:
  explicit Painter(CellMap& map) : map_(map) {}

  // Every cell that the closed segment meets.
  void line(Point a, Point b) {
    if (a.y > b.y) std::swap(a, b);
    const int last = std::min(map_.rows - 1, below(b.y + kCellRounding));
    for (int row = std::max(0, below(a.y - kCellRounding)); row <= last; ++row) {
      const double y0 = std::clamp(double(row) - kCellRounding, a.y, b.y);
      const double y1 = std::clamp(double(row) + 1 + kCellRounding, a.y, b.y);
      const double x0 = at(a, b, y0), x1 = at(a, b, y1);
      const bool flat = a.y == b.y;
      mark(row, flat ? std::min(a.x, b.x) : std::min(x0, x1), flat ? std::max(a.x, b.x) : std::max(x0, x1));
    }
  }

  // Every cell whose middle the outer ring goes around and no hole does.
  void inside(const Ring& outer, const std::vector<Ring>& holes) {
    const auto [low, high] = std::minmax_element(outer.begin(), outer.end(), [](auto a, auto b) { return a.y < b.y; });
    const int last = std::min(map_.rows - 1, below(high->y));
    for (int row = std::max(0, below(low->y)); row <= last; ++row) {
      crossings_.clear();
      cross_row(outer, row + 0.5, 1, 0);
      if (crossings_.empty()) continue;
      for (const Ring& hole : holes) cross_row(hole, row + 0.5, 0, 1);
      std::sort(crossings_.begin(), crossings_.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
      int solid = 0, open = 0;
      for (std::size_t i = 0; i + 1 < crossings_.size(); ++i) {
        solid += crossings_[i].outer;
        open += crossings_[i].hole;
        if (solid != 0 && open == 0) fill_middles(row, crossings_[i].x, crossings_[i + 1].x);
      }
    }
  }

 private:
  struct Crossing {
    double x;
    int outer, hole;  // what the windings rise by from left to right
  };

  int below(double y) const { return static_cast<int>(std::floor(std::clamp(y, -1.0, double(map_.rows)))); }
  int left_of(double x) const { return static_cast<int>(std::floor(std::clamp(x, -1.0, double(map_.columns)))); }

  static double at(Point a, Point b, double y) {
    return a.y == b.y
               ? a.x
               : std::clamp(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)), std::min(a.x, b.x), std::max(a.x, b.x));
  }

  void mark(int row, double from, double to) {
    const int last = std::min(map_.columns - 1, left_of(to + kCellRounding));
    for (int column = std::max(0, left_of(from - kCellRounding)); column <= last; ++column)
      map_.occupied[cell_number(map_, column, row)] = 1;
  }

  void fill_middles(int row, double from, double to) {
    const int last = std::min(map_.columns - 1, left_of(to - 0.5));
    for (int column = std::max(0, left_of(from + 0.5)); column <= last; ++column)
      map_.occupied[cell_number(map_, column, row)] = 1;
  }

  void cross_row(const Ring& ring, double y, int outer, int hole) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y <= y) == (b.y <= y)) continue;
      const int sign = a.y <= y ? 1 : -1;
      crossings_.push_back({at(a, b, y), sign * outer, sign * hole});
    }
  }

  CellMap& map_;
  std::vector<Crossing> crossings_;
};

Ring in_cells(const CellMap& map, const Ring& world, const std::string& label) {
  const CellFrame frame(map);
  Ring ring;
  for (const Point p : world) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw InputError(label + ": a coordinate is not a finite number");
    ring.push_back(frame.cells(p));
  }
  return ring;
}

void outline(Painter& painter, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) painter.line(ring[i], ring[(i + 1) % ring.size()]);
}

void paint(Painter& painter, const CellMap& map, const Obstacle& obstacle) {
  const Ring outer = in_cells(map, obstacle.outer, obstacle.label);
  std::vector<Ring> holes;
  for (const Ring& hole : obstacle.holes) holes.push_back(in_cells(map, hole, obstacle.label));
  outline(painter, outer);
  for (const Ring& hole : holes) outline(painter, hole);
  painter.inside(outer, holes);
}

}  // namespace

CellMap resampled(const CellMap& map, double size) {
  const double factor = size / map.resolution;
  if (factor < 1 - 1e-9) {
    throw InputError(option(size) +
                     printed(": finer than the map, whose cells are %.10g m: give at least that", map.resolution));
  }
  CellMap result = empty_map(map.columns * map.resolution, map.rows * map.resolution, size, map.origin, map.yaw);
  for (int row = 0; row < map.rows; ++row) {
    const Range rows = met_by(row, factor, result.rows);
    for (int column = 0; column < map.columns; ++column) {
      if (!map.at(column, row)) continue;
      const Range columns = met_by(column, factor, result.columns);
      for (int y = rows.first; y <= rows.last; ++y) {
        for (int x = columns.first; x <= columns.last; ++x) result.occupied[cell_number(result, x, y)] = 1;
      }
    }
  }
  return result;
}

CellMap drawn_in_cells(const Workspace& drawing, double size) {
  CellMap map = empty_map(drawing.max.x - drawing.min.x, drawing.max.y - drawing.min.y, size, drawing.min, 0);
  Painter painter(map);
  for (const Obstacle& obstacle : drawing.obstacles) {
    if (!obstacle.outer.empty()) paint(painter, map, obstacle);
  }
  return map;
}

}  // namespace krait::host
