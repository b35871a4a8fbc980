// SPDX-License-Identifier: Apache-2.0
#include "krait/collision/obstacles.hpp"

namespace krait {
namespace {

float least(float a, float b) { return b < a ? b : a; }
float most(float a, float b) { return b > a ? b : a; }

struct Interval {
  float low;
  float high;
};

float gap(Interval a, Interval b) { return most(most(a.low - b.high, b.low - a.high), 0.0F); }

float squared_distance(const Box& a, const Box& b) {
  const float dx = gap({a.min.x, a.max.x}, {b.min.x, b.max.x});
  const float dy = gap({a.min.y, a.max.y}, {b.min.y, b.max.y});
  return dx * dx + dy * dy;
}

// Of a polygon onto a direction, in lengths of that.
Interval projection(Polygon polygon, Vec2 direction) {
  Interval reached{kInfinity, -kInfinity};
  for (int i = 0; i < polygon.count; ++i) {
    const float along = dot(direction, polygon[i]);
    reached = {least(reached.low, along), most(reached.high, along)};
  }
  return reached;
}

// Whether a line along or across the body's first edge keeps the polygons further apart than `distance`.
bool far_apart(Polygon body, Polygon piece, float distance) {
  Vec2 direction = body[1] - body[0];
  const float scaled = distance * length(direction);
  for (int turn = 0; turn < 2; ++turn) {
    if (gap(projection(body, direction), projection(piece, direction)) > scaled) return true;
    direction = {-direction.y, direction.x};
  }
  return false;
}

// Whether `cell` is the first of the query's cells that the box meets: lets each piece be tested once.
bool first_meeting(const CellGrid& grid, const Box& box, Cell first, Cell cell) {
  const Cell corner = grid.cell(box.min);
  const std::int32_t column = corner.column > first.column ? corner.column : first.column;
  const std::int32_t row = corner.row > first.row ? corner.row : first.row;
  return cell.column == column && cell.row == row;
}

}  // namespace

Obstacles::Obstacles(const Scene& scene, float clearance, bool shortcuts) : scene_(&scene), shortcuts_(shortcuts) {
  const Box bounds = scene.bounds();
  const float largest =
      most(most(absolute(bounds.min.x), absolute(bounds.min.y)), most(absolute(bounds.max.x), absolute(bounds.max.y)));
  margin_ = clearance + kRounding + kPositionRounding * largest + scene.header().obstacle_error;
}

float Obstacles::room_to_bounds(const Box& box) const {
  const Box bounds = scene_->bounds();
  const float x = least(box.min.x - bounds.min.x, bounds.max.x - box.max.x);
  const float y = least(box.min.y - bounds.min.y, bounds.max.y - box.max.y);
  return least(x, y) - margin_;
}

float Obstacles::room_to_piece(const PlacedBody& body, Index piece, float reach) const {
  const Polygon source = scene_->piece(piece);
  Vec2 relative[format::kMaxPieceVertices];
  float extent = 0.0F;
  for (int i = 0; i < source.count; ++i) {
    relative[i] = source[i] - body.at;
    extent = most(extent, most(absolute(relative[i].x), absolute(relative[i].y)));
  }
  const Polygon shifted{relative, source.count};
  const float taken = margin_ + kRelativeRounding * extent;
  if (shortcuts_ && far_apart(body.polygon(), shifted, reach + taken + kRelativeRounding * extent)) return reach;
  return polygon_distance(body.polygon(), shifted) - taken;
}

// Calls visit(piece) for every piece whose box comes within `around` of the box, until it says false.
template <class Visit>
void Obstacles::pieces_around(const Box& box, float around, Visit visit) const {
  if (shortcuts_) return pieces_of_buckets(box, around, visit);
  for (Index piece = 0; piece < scene_->piece_count(); ++piece) {
    if (squared_distance(box, scene_->piece_box(piece)) <= around * around && !visit(piece)) return;
  }
}

template <class Visit>
void Obstacles::pieces_of_buckets(const Box& box, float around, Visit visit) const {
  const CellGrid& grid = scene_->buckets();
  const Cell low = grid.cell(box.min - Vec2{around, around});
  const Cell high = grid.cell(box.max + Vec2{around, around});
  for (Cell cell = low; cell.row <= high.row; ++cell.row) {
    for (cell.column = low.column; cell.column <= high.column; ++cell.column) {
      const std::size_t bucket = grid.index(cell);
      const std::uint32_t end = scene_->bucket_pieces_begin(bucket + 1);
      for (std::uint32_t i = scene_->bucket_pieces_begin(bucket); i < end; ++i) {
        const Index piece = scene_->bucket_piece(i);
        const Box piece_box = scene_->piece_box(piece);
        if (squared_distance(box, piece_box) > around * around || !first_meeting(grid, piece_box, low, cell)) continue;
        if (!visit(piece)) return;
      }
    }
  }
}

float Obstacles::room(const PlacedBody& body, float reach) const {
  Box box = bounding_box(body.polygon());
  box = {body.at + box.min, body.at + box.max};
  if (!(finite(box.min) && finite(box.max))) return -kInfinity;
  float room = least(room_to_bounds(box), reach);
  if (room <= 0.0F) return room;
  pieces_around(box, reach + margin_, [&](Index piece) {
    room = least(room, room_to_piece(body, piece, room));
    return room > 0.0F;
  });
  return room;
}

}  // namespace krait
