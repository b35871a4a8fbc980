#include "krait/collision/obstacles.hpp"

namespace krait {
namespace {

float least(float a, float b) { return b < a ? b : a; }
float most(float a, float b) { return b > a ? b : a; }
float absolute(float x) { return x < 0.0F ? -x : x; }

// Gap between a point and a box along one axis.
float outside(float x, float low, float high) { return most(most(low - x, x - high), 0.0F); }

float squared_distance(Vec2 p, const Box& box) {
  const float dx = outside(p.x, box.min.x, box.max.x);
  const float dy = outside(p.y, box.min.y, box.max.y);
  return dx * dx + dy * dy;
}

// Whether `cell` is the first of the query's cells that the box meets: lets each piece be tested once.
bool first_meeting(const CellGrid& grid, const Box& box, Cell first, Cell cell) {
  const Cell corner = grid.cell(box.min);
  const std::int32_t column = corner.column > first.column ? corner.column : first.column;
  const std::int32_t row = corner.row > first.row ? corner.row : first.row;
  return cell.column == column && cell.row == row;
}

}  // namespace

Obstacles::Obstacles(const Scene& scene, float clearance) : scene_(&scene) {
  const Box bounds = scene.bounds();
  const float largest =
      most(most(absolute(bounds.min.x), absolute(bounds.min.y)), most(absolute(bounds.max.x), absolute(bounds.max.y)));
  margin_ = clearance + kRounding + kPositionRounding * largest + scene.header().obstacle_error;
}

float Obstacles::room_to_bounds(const PlacedBody& body) const {
  const Box bounds = scene_->bounds();
  float room = kInfinity;
  for (int i = 0; i < body.count; ++i) {
    const Vec2 p = body.at + body.vertices[i];
    room = least(room,
                 least(least(p.x - bounds.min.x, bounds.max.x - p.x), least(p.y - bounds.min.y, bounds.max.y - p.y)));
  }
  return room - margin_;
}

float Obstacles::distance_to_piece(const PlacedBody& body, Index piece) const {
  const Polygon source = scene_->piece(piece);
  Vec2 relative[format::kMaxPieceVertices];
  float extent = 0.0F;
  for (int i = 0; i < source.count; ++i) {
    relative[i] = source[i] - body.at;
    extent = most(extent, most(absolute(relative[i].x), absolute(relative[i].y)));
  }
  return polygon_distance(body.polygon(), {relative, source.count}) - kRelativeRounding * extent;
}

float Obstacles::room(const PlacedBody& body, float reach) const {
  if (!finite(body.center)) return -kInfinity;
  float room = least(room_to_bounds(body), reach);
  if (room <= 0.0F) return room;
  const float around = body.radius + reach + margin_;
  const CellGrid& grid = scene_->buckets();
  const Cell low = grid.cell(body.center - Vec2{around, around});
  const Cell high = grid.cell(body.center + Vec2{around, around});
  for (Cell cell = low; cell.row <= high.row; ++cell.row) {
    for (cell.column = low.column; cell.column <= high.column; ++cell.column) {
      const std::size_t bucket = grid.index(cell);
      const std::uint32_t end = scene_->bucket_pieces_begin(bucket + 1);
      for (std::uint32_t i = scene_->bucket_pieces_begin(bucket); i < end; ++i) {
        const Index piece = scene_->bucket_piece(i);
        const Box box = scene_->piece_box(piece);
        if (squared_distance(body.center, box) > around * around || !first_meeting(grid, box, low, cell)) continue;
        room = least(room, distance_to_piece(body, piece) - margin_);
        if (room <= 0.0F) return room;
      }
    }
  }
  return room;
}

}  // namespace krait
