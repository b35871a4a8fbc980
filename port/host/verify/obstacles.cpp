// SPDX-License-Identifier: Apache-2.0
#include "host/verify/obstacles.hpp"

#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <limits>

#include "host/verify/complaints.hpp"
#include "host/verify/pieces.hpp"

namespace krait::host {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

Obstacle shifted(Obstacle obstacle, const Point& lower) {
  const auto shift = [&](Ring& ring) {
    for (Point& point : ring) point = {point.x - lower.x, point.y - lower.y};
  };
  shift(obstacle.outer);
  for (Ring& hole : obstacle.holes) shift(hole);
  return obstacle;
}

// How far `b` reaches through the side of `a` from which it is the easiest to push out.
double depth_through_sides(const Convex& a, const Convex& b) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    const Point side{a[i + 1].x - a[i].x, a[i + 1].y - a[i].y};
    const double length = std::hypot(side.x, side.y);
    if (length == 0) continue;
    double deepest = -std::numeric_limits<double>::infinity();
    for (const Point& p : b) {
      deepest = std::max(deepest, ((p.x - a[i].x) * side.y - (p.y - a[i].y) * side.x) / length);
    }
    depth = std::min(depth, deepest);
  }
  return depth;
}

double overlap_depth(const Convex& a, const Convex& b) {
  return std::max(0.0, std::min(depth_through_sides(a, b), depth_through_sides(b, a)));
}

Convex ring_of(const Box& box) {
  Convex ring;
  bg::convert(box, ring);
  return ring;
}

Box grown(Box box, double by) {
  bg::buffer(Box(box), box, by);
  return box;
}

// Distance from inside to the sides of the rectangle from (0, 0) to `size`.
double room_in(const Convex& body, const Point& size) {
  double room = std::min(size.x, size.y);
  for (const Point& p : body) room = std::min({room, p.x, p.y, size.x - p.x, size.y - p.y});
  return room;
}

// Looks at each indexed shape near the body: `shape_of` returns it, `found` is called with each that is nearer than
// those before.
template <typename Index, typename BoxOf, typename ShapeOf, typename Found>
void search(const Index& index, const Convex& body, Contact& contact, BoxOf box_of, ShapeOf shape_of, Found found) {
  const Box box = bg::return_envelope<Box>(body);
  const auto consider = [&](const typename Index::value_type& value) {
    if (contact.distance <= 0 || bg::distance(box, box_of(value)) >= contact.distance) return;
    const Convex& shape = shape_of(value);
    const double distance = bg::distance(body, shape);
    if (distance >= contact.distance) return;
    contact = {distance, found(value), distance > 0 ? 0 : overlap_depth(body, shape)};
  };
  index.query(bgi::intersects(grown(box, contact.distance)), boost::make_function_output_iterator(consider));
}

std::string cells_label(const Box& run, double resolution) {
  const auto cell = [&](double coordinate) { return std::to_string(std::llround(coordinate / resolution)); };
  const double last = run.max_corner().x - resolution;
  return "map row " + cell(run.min_corner().y) + ", columns " + cell(run.min_corner().x) + " to " + cell(last);
}

}  // namespace

Obstacles::Obstacles(const Workspace& workspace)
    : size_{workspace.max.x - workspace.min.x, workspace.max.y - workspace.min.y} {
  if (!(size_.x > 0 && size_.y > 0 && std::isfinite(size_.x) && std::isfinite(size_.y))) {
    throw InputError("bounds: the workspace has no finite, positive size");
  }
  std::vector<Pieces::value_type> boxes;
  for (const Obstacle& obstacle : workspace.obstacles) {
    for (const Ring& ring : convex_pieces(shifted(obstacle, workspace.min))) {
      pieces_.push_back(hull_of(ring));
      labels_.push_back(obstacle.label);
      boxes.emplace_back(bg::return_envelope<Box>(pieces_.back()), static_cast<std::uint32_t>(boxes.size()));
    }
  }
  piece_index_ = Pieces(boxes);
  if (workspace.cells) add_cells(*workspace.cells, workspace.min);
}

void Obstacles::add_cells(const CellMap& map, const Point& lower) {
  const bool sane = map.columns > 0 && map.rows > 0 && map.resolution > 0 && std::isfinite(map.resolution) &&
                    std::isfinite(map.yaw) && std::isfinite(map.origin.x) && std::isfinite(map.origin.y) &&
                    map.occupied.size() == static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
  if (!sane) throw InputError("map: its size, resolution or origin is unusable");
  has_map_ = true;
  resolution_ = map.resolution;
  map_ = {{map.origin.x - lower.x, map.origin.y - lower.y}, std::cos(map.yaw), std::sin(map.yaw)};
  map_size_ = {map.columns * map.resolution, map.rows * map.resolution};

  std::vector<Box> runs;
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      if (!map.at(column, row)) continue;
      const int first = column;
      while (column < map.columns && map.at(column, row)) ++column;
      runs.emplace_back(Point{first * resolution_, row * resolution_},
                        Point{column * resolution_, (row + 1) * resolution_});
    }
  }
  cell_index_ = Cells(runs);
}

Convex Obstacles::in_map(const Convex& body) const {
  Convex moved = body;
  for (Point& point : moved) point = map_.inverse(point);
  return moved;
}

Contact Obstacles::nearest(const Convex& body, double reach) const {
  Contact contact{reach, {}};
  search(
      piece_index_, body, contact, [](const Pieces::value_type& value) { return value.first; },
      [&](const Pieces::value_type& value) -> const Convex& { return pieces_[value.second]; },
      [&](const Pieces::value_type& value) { return labels_[value.second]; });
  if (has_map_) {
    search(
        cell_index_, in_map(body), contact, [](const Box& run) { return run; }, ring_of,
        [&](const Box& run) { return cells_label(run, resolution_); });
  }
  return contact;
}

double Obstacles::room(const Convex& body) const {
  const double room = room_in(body, size_);
  return has_map_ ? std::min(room, room_in(in_map(body), map_size_)) : room;
}

}  // namespace krait::host
