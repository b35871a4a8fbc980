// SPDX-License-Identifier: Apache-2.0
#include "field.hpp"

#include <cmath>
#include <limits>

namespace krait::campaign {
namespace {

constexpr int kMostBuckets = 400;  // either way

double squared_to_segment(double px, double py, double ax, double ay, double bx, double by) {
  const double dx = bx - ax, dy = by - ay, length = dx * dx + dy * dy;
  const double along = length > 0 ? std::clamp(((px - ax) * dx + (py - ay) * dy) / length, 0.0, 1.0) : 0;
  const double ex = ax + along * dx - px, ey = ay + along * dy - py;
  return ex * ex + ey * ey;
}

// The largest gap between a and b along the outward normal of a side of a; negative: they overlap along each.
double widest_gap(const Convex& a, const Convex& b) {
  double widest = -std::numeric_limits<double>::infinity();
  for (int i = 0, j = a.count - 1; i < a.count; j = i++) {
    double nx = a.y[i] - a.y[j], ny = a.x[j] - a.x[i];
    const double length = std::sqrt(nx * nx + ny * ny);
    if (!(length > 0)) continue;
    nx /= length;
    ny /= length;
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < b.count; ++k) nearest = std::min(nearest, nx * (b.x[k] - a.x[i]) + ny * (b.y[k] - a.y[i]));
    widest = std::max(widest, nearest);
  }
  return widest;
}

double squared_to_sides(const Convex& points, const Convex& sides) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0, j = sides.count - 1; i < sides.count; j = i++) {
    for (int k = 0; k < points.count; ++k) {
      least =
          std::min(least, squared_to_segment(points.x[k], points.y[k], sides.x[j], sides.y[j], sides.x[i], sides.y[i]));
    }
  }
  return least;
}

// As apart(), and any number above `enough` where the distance is at least that.
double apart_up_to(const Convex& a, const Convex& b, double enough) {
  const double gap = std::max(widest_gap(a, b), widest_gap(b, a));
  if (gap <= 0 || gap >= enough) return gap;
  return std::sqrt(std::min(squared_to_sides(a, b), squared_to_sides(b, a)));
}

Box grown(const Box& box, double by) { return {box.left - by, box.bottom - by, box.right + by, box.top + by}; }

// How often the ring winds around the point.
int winding(const host::Ring& ring, double x, double y) {
  int turns = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const host::Point a = ring[j], b = ring[i];
    if ((a.y > y) == (b.y > y)) continue;
    const double side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    if (b.y > a.y && side > 0) ++turns;
    if (b.y < a.y && side < 0) --turns;
  }
  return turns;
}

}  // namespace

Placed placed(const Convex& body, const Frame& frame) {
  Placed result;
  Box& box = result.box;
  box = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
         -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int i = 0; i < body.count; ++i) {
    const double x = frame.x + frame.cos * body.x[i] - frame.sin * body.y[i];
    const double y = frame.y + frame.sin * body.x[i] + frame.cos * body.y[i];
    result.shape.add(x, y);
    box = {std::min(box.left, x), std::min(box.bottom, y), std::max(box.right, x), std::max(box.top, y)};
  }
  return result;
}

double apart(const Convex& a, const Convex& b) { return apart_up_to(a, b, std::numeric_limits<double>::infinity()); }

Field::Field(const host::Workspace& workspace, host::Point origin)
    : bounds_{workspace.min.x - origin.x, workspace.min.y - origin.y, workspace.max.x - origin.x,
              workspace.max.y - origin.y} {
  for (const host::Obstacle& obstacle : workspace.obstacles) {
    outlines_.emplace_back();
    add_ring(obstacle.outer, origin);
    for (const host::Ring& hole : obstacle.holes) add_ring(hole, origin);
  }
  if (workspace.cells) add_cells(*workspace.cells, origin);
  fill_buckets();
}

void Field::add_ring(const host::Ring& ring, host::Point origin) {
  host::Ring moved;
  for (const host::Point p : ring) moved.push_back({p.x - origin.x, p.y - origin.y});
  for (std::size_t i = 0, j = moved.size() - 1; i < moved.size(); j = i++) {
    edges_.push_back({moved[j].x, moved[j].y, moved[i].x, moved[i].y});
  }
  outlines_.back().rings.push_back(std::move(moved));
}

// An edge for every straight run of borders between an occupied cell and one that is not.
void Field::add_cells(const host::CellMap& map, host::Point origin) {
  cells_ = map;
  cells_.origin = {map.origin.x - origin.x, map.origin.y - origin.y};
  cells_cos_ = std::cos(map.yaw);
  cells_sin_ = std::sin(map.yaw);
  const auto occupied = [&](int column, int row) {
    return column >= 0 && row >= 0 && column < map.columns && row < map.rows && map.at(column, row);
  };
  const auto corner = [&](int column, int row) {
    const double x = column * map.resolution, y = row * map.resolution;
    return host::Point{cells_.origin.x + cells_cos_ * x - cells_sin_ * y,
                       cells_.origin.y + cells_sin_ * x + cells_cos_ * y};
  };
  const auto runs = [&](int lines, int length, auto border, auto point) {
    for (int line = 0; line <= lines; ++line) {
      for (int from = 0; from < length; ++from) {
        if (!border(line, from)) continue;
        int to = from;
        while (to < length && border(line, to)) ++to;
        const host::Point a = point(line, from), b = point(line, to);
        edges_.push_back({a.x, a.y, b.x, b.y});
        from = to;
      }
    }
  };
  runs(
      map.rows, map.columns, [&](int row, int column) { return occupied(column, row - 1) != occupied(column, row); },
      [&](int row, int column) { return corner(column, row); });
  runs(
      map.columns, map.rows, [&](int column, int row) { return occupied(column - 1, row) != occupied(column, row); },
      corner);
}

void Field::fill_buckets() {
  const double width = bounds_.right - bounds_.left, height = bounds_.top - bounds_.bottom;
  size_ = std::max(width, height) / kMostBuckets;
  columns_ = static_cast<int>(width / size_) + 1;
  rows_ = static_cast<int>(height / size_) + 1;
  std::vector<std::vector<std::uint32_t>> buckets(bucket(0, rows_));
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const Edge& e = edges_[i];
    const Range r = range({std::min(e.ax, e.bx), std::min(e.ay, e.by), std::max(e.ax, e.bx), std::max(e.ay, e.by)});
    for (int row = r.bottom; row <= r.top; ++row) {
      for (int column = r.left; column <= r.right; ++column) {
        if (meets(e, column, row)) buckets[bucket(column, row)].push_back(i);
      }
    }
  }
  const std::size_t stride = static_cast<std::size_t>(columns_) + 1;
  sums_.assign(stride * (static_cast<std::size_t>(rows_) + 1), 0);
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    offsets_.push_back(static_cast<std::uint32_t>(list_.size()));
    list_.insert(list_.end(), buckets[b].begin(), buckets[b].end());
    const std::size_t at =
        (b / static_cast<std::size_t>(columns_) + 1) * stride + b % static_cast<std::size_t>(columns_) + 1;
    sums_[at] =
        static_cast<std::uint32_t>(buckets[b].size()) + sums_[at - 1] + sums_[at - stride] - sums_[at - stride - 1];
  }
  offsets_.push_back(static_cast<std::uint32_t>(list_.size()));
}

// Those that the box meets, and none outside the grid: edges out there are in the outermost buckets.
Field::Range Field::range(const Box& box) const {
  const auto at = [this](double x, double low, int count) {
    return static_cast<int>(std::clamp(std::floor((x - low) / size_), 0.0, count - 1.0));
  };
  return {at(box.left, bounds_.left, columns_), at(box.bottom, bounds_.bottom, rows_),
          at(box.right, bounds_.left, columns_), at(box.top, bounds_.bottom, rows_)};
}

// Whether the edge's line meets the bucket, a little widened; the outermost reach without end.
bool Field::meets(const Edge& edge, int column, int row) const {
  if (column == 0 || row == 0 || column == columns_ - 1 || row == rows_ - 1) return true;
  const double half = size_ / 2 + 1e-6 * size_;
  const double x = bounds_.left + (column + 0.5) * size_, y = bounds_.bottom + (row + 0.5) * size_;
  const double nx = edge.ay - edge.by, ny = edge.bx - edge.ax;
  return std::abs(nx * (x - edge.ax) + ny * (y - edge.ay)) <= half * (std::abs(nx) + std::abs(ny));
}

bool Field::empty(const Range& r) const {
  const std::size_t stride = static_cast<std::size_t>(columns_) + 1;
  const auto sum = [&](int column, int row) {
    return sums_[static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(column)];
  };
  return sum(r.right + 1, r.top + 1) + sum(r.left, r.bottom) == sum(r.left, r.top + 1) + sum(r.right + 1, r.bottom);
}

bool Field::clear(const Box& box) const {
  return box.left >= bounds_.left && box.right <= bounds_.right && box.bottom >= bounds_.bottom &&
         box.top <= bounds_.top && empty(range(box));
}

double Field::room(const Placed& body, double reach) const {
  const Box& b = body.box;
  double least =
      std::min({reach, b.left - bounds_.left, bounds_.right - b.right, b.bottom - bounds_.bottom, bounds_.top - b.top});
  const Range r = range(grown(b, reach));
  if (empty(r)) return least;
  for (int row = r.bottom; row <= r.top; ++row) {
    for (std::uint32_t i = offsets_[bucket(r.left, row)]; i < offsets_[bucket(r.right, row) + 1]; ++i) {
      const Edge& e = edges_[list_[i]];
      const double gap_x = std::max(b.left - std::max(e.ax, e.bx), std::min(e.ax, e.bx) - b.right);
      const double gap_y = std::max(b.bottom - std::max(e.ay, e.by), std::min(e.ay, e.by) - b.top);
      if (std::max(gap_x, gap_y) >= least) continue;
      Convex edge;
      edge.add(e.ax, e.ay);
      edge.add(e.bx, e.by);
      least = std::min(least, apart_up_to(body.shape, edge, least));
    }
  }
  return least;
}

bool Field::inside(const Placed& body) const {
  for (int i = 0; i < body.shape.count; ++i) {
    if (solid(body.shape.x[i], body.shape.y[i])) return true;
  }
  return false;
}

bool Field::solid(double x, double y) const {
  if (x < bounds_.left || x > bounds_.right || y < bounds_.bottom || y > bounds_.top) return true;
  for (const Outline& outline : outlines_) {
    bool filled = winding(outline.rings[0], x, y) != 0;
    for (std::size_t i = 1; filled && i < outline.rings.size(); ++i) filled = winding(outline.rings[i], x, y) == 0;
    if (filled) return true;
  }
  if (cells_.columns == 0) return false;
  const double dx = x - cells_.origin.x, dy = y - cells_.origin.y;
  const double column = std::floor((cells_cos_ * dx + cells_sin_ * dy) / cells_.resolution);
  const double row = std::floor((cells_cos_ * dy - cells_sin_ * dx) / cells_.resolution);
  return column >= 0 && row >= 0 && column < cells_.columns && row < cells_.rows &&
         cells_.at(static_cast<int>(column), static_cast<int>(row));
}

}  // namespace krait::campaign
