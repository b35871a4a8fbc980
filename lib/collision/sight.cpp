// SPDX-License-Identifier: Apache-2.0
#include "collision/sight.hpp"

#include <algorithm>

namespace krait::detail {
namespace {

// Whether a point lies further than `reach` from a convex polygon.
bool apart(Polygon piece, Vec2 point, float reach) {
  const float squared = reach * reach;
  bool outside = false;
  bool near = false;
  Vec2 corner = piece[piece.count - 1];
  for (int i = 0; i < piece.count; ++i) {
    const Vec2 edge = piece[i] - corner;
    const Vec2 to = point - corner;
    const float right = cross(to, edge);
    const float scale = dot(edge, edge);
    if (right > 0.0F) {
      if (right * right > squared * scale) return true;
      const float along = dot(to, edge);
      outside = true;
      near = near || (along >= 0.0F && along <= scale);
    }
    near = near || dot(to, to) <= squared;
    corner = piece[i];
  }
  return outside && !near;
}

}  // namespace

// A piece that several buckets list is looked at in each.
bool Sight::apart_from_pieces(Vec2 center) const {
  const CellGrid& grid = scene_->buckets();
  const Cell low = grid.cell(center - Vec2{radius_, radius_});
  const Cell high = grid.cell(center + Vec2{radius_, radius_});
  for (Cell cell = low; cell.row <= high.row; ++cell.row) {
    for (cell.column = low.column; cell.column <= high.column; ++cell.column) {
      const std::size_t bucket = grid.index(cell);
      const std::uint32_t end = scene_->bucket_pieces_begin(bucket + 1);
      for (std::uint32_t i = scene_->bucket_pieces_begin(bucket); i < end; ++i) {
        if (!apart(scene_->piece(scene_->bucket_piece(i)), center, radius_)) return false;
      }
    }
  }
  return true;
}

float Sight::slack_near(Vec2 center) const {
  const Box bounds = scene_->bounds();
  const bool within = center.x - bounds.min.x > radius_ && bounds.max.x - center.x > radius_ &&
                      center.y - bounds.min.y > radius_ && bounds.max.y - center.y > radius_;
  return within && apart_from_pieces(center) ? 0.0F : -1.0F;
}

bool Sight::line_free(Vec2 a, Vec2 b) const {
  const float far = length(b - a);
  if (!(far > step_)) return true;
  const Vec2 along = (1.0F / far) * (b - a);
  float gone = step_;
  for (int looks = 0; looks < kMostLooks; ++looks) {
    const float room = slack(a + gone * along);
    if (room < 0.0F) return false;
    gone = gone + std::max(step_, room);
    if (!(gone < far)) return true;
  }
  return false;
}

}  // namespace krait::detail
