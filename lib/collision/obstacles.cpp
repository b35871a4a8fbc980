// SPDX-License-Identifier: Apache-2.0
#include "collision/obstacles.hpp"

#include <algorithm>

namespace krait::detail {
namespace {

struct Interval {
  float low;
  float high;
};

float gap(Interval a, Interval b) { return std::max(std::max(a.low - b.high, b.low - a.high), 0.0F); }

float squared_distance(const Box& a, const Box& b) {
  const float dx = gap({a.min.x, a.max.x}, {b.min.x, b.max.x});
  const float dy = gap({a.min.y, a.max.y}, {b.min.y, b.max.y});
  return dx * dx + dy * dy;
}

// The projection of a polygon onto a direction, in lengths of that.
Interval projection(Polygon polygon, Vec2 direction) {
  Interval reached{kInfinity, -kInfinity};
  for (int i = 0; i < polygon.count; ++i) {
    const float along = dot(direction, polygon[i]);
    reached = {std::min(reached.low, along), std::max(reached.high, along)};
  }
  return reached;
}

// Whether a line along or across the body's first edge keeps the polygons further apart than `distance`.
[[gnu::flatten]] bool far_apart(Polygon body, Polygon piece, float distance) {
  Vec2 direction = body[1] - body[0];
  const float scaled = distance * length(direction);
  for (int turn = 0; turn < 2; ++turn) {
    if (gap(projection(body, direction), projection(piece, direction)) > scaled) return true;
    direction = {-direction.y, direction.x};
  }
  return false;
}

// A piece with its vertices relative to a point near it.
struct ShiftedPiece {
  ShiftedPiece(Polygon piece, Vec2 at) : count(piece.count) {
    for (int i = 0; i < count; ++i) {
      vertices[i] = piece[i] - at;
      extent = std::max(extent, std::max(math::absolute(vertices[i].x), math::absolute(vertices[i].y)));
    }
  }
  Polygon polygon() const { return {vertices, count}; }

  Vec2 vertices[format::kMaxPieceVertices];
  int count;
  float extent = 0.0F;  // the largest coordinate
};

// Whether `cell` is the first of the query's cells that the box meets: lets each piece be tested once.
bool first_meeting(const CellGrid& grid, const Box& box, Cell first, Cell cell) {
  const Cell corner = grid.cell(box.min);
  const std::int32_t column = std::max(first.column, corner.column);
  const std::int32_t row = std::max(first.row, corner.row);
  return cell.column == column && cell.row == row;
}

}  // namespace

Obstacles::Obstacles(const Scene& scene, float clearance, bool shortcuts) : scene_(&scene), shortcuts_(shortcuts) {
  const Box bounds = scene.bounds();
  const float largest = std::max(std::max(math::absolute(bounds.min.x), math::absolute(bounds.min.y)),
                                 std::max(math::absolute(bounds.max.x), math::absolute(bounds.max.y)));
  margin_ = clearance + kRounding + kPositionRounding * largest + scene.header().obstacle_error;
}

float Obstacles::room_to_bounds(const Box& box) const {
  const Box bounds = scene_->bounds();
  const float x = std::min(box.min.x - bounds.min.x, bounds.max.x - box.max.x);
  const float y = std::min(box.min.y - bounds.min.y, bounds.max.y - box.max.y);
  return std::min(x, y) - margin_;
}

// Stands in the program once.
[[gnu::noinline, gnu::flatten]] float Obstacles::room_to_piece(const PlacedBody& body, Index piece, float reach) const {
  const ShiftedPiece shifted(scene_->piece(piece), body.at);
  const float rounding = kRelativeRounding * shifted.extent;
  const float taken = margin_ + rounding;
  if (shortcuts_ && far_apart(body.polygon(), shifted.polygon(), reach + taken + rounding)) return reach;
  return polygon_distance(body.polygon(), shifted.polygon()) - taken;
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

[[gnu::flatten]] float Obstacles::room(const PlacedBody& body, float reach) const {
  Box box = bounding_box(body.polygon());
  box = {body.at + box.min, body.at + box.max};
  if (!(finite(box.min) && finite(box.max))) return -kInfinity;
  float room = std::min(room_to_bounds(box), reach);
  if (room <= 0.0F) return room;
  pieces_around(box, reach + margin_, [&](Index piece) {
    room = std::min(room, room_to_piece(body, piece, room));
    return room > 0.0F;
  });
  return room;
}

// The contact names the vertex that lies furthest outside of the bounds.
Contact Obstacles::contact_with_bounds(const PlacedBody& body) const {
  const Box bounds = scene_->bounds();
  Contact contact{ContactKind::bounds, 0, kNone, kInfinity, margin_, {}};
  for (int i = 0; i < body.count; ++i) {
    const Vec2 at = body.at + body.vertices[i];
    const float room = std::min(std::min(at.x - bounds.min.x, bounds.max.x - at.x),
                                std::min(at.y - bounds.min.y, bounds.max.y - at.y));
    if (room >= contact.distance) continue;
    contact.distance = room;
    contact.at = at;
  }
  if (!(contact.distance <= margin_)) return {};
  contact.distance = std::max(contact.distance, 0.0F);
  return contact;
}

Contact Obstacles::contact(const PlacedBody& body) const {
  Box box = bounding_box(body.polygon());
  box = {body.at + box.min, body.at + box.max};
  Contact worst = contact_with_bounds(body);
  if (!(finite(box.min) && finite(box.max))) return worst;
  pieces_around(box, kLookBeyond + margin_, [&](Index piece) {
    const ShiftedPiece shifted(scene_->piece(piece), body.at);
    const float needed = margin_ + kRelativeRounding * shifted.extent;
    const Gap gap = polygon_gap(body.polygon(), shifted.polygon());
    const float lacking = needed - gap.distance;
    if (!(lacking < 0.0F) && (worst.kind == ContactKind::none || lacking > worst.needed - worst.distance)) {
      worst = {ContactKind::obstacle, 0, piece, gap.distance, needed, body.at + gap.middle};
    }
    return true;
  });
  return worst;
}

float Obstacles::distance(Vec2 point, float reach) const {
  const Vec2 origin[1] = {};
  float nearest = std::min(room_to_bounds({point, point}) + margin_, reach);
  if (!(nearest > 0.0F)) return 0.0F;
  pieces_around({point, point}, reach, [&](Index piece) {
    const ShiftedPiece shifted(scene_->piece(piece), point);
    nearest = std::min(nearest, polygon_distance({origin, 1}, shifted.polygon()));
    return nearest > 0.0F;
  });
  return nearest;
}

}  // namespace krait::detail
