// SPDX-License-Identifier: Apache-2.0
#include "host/rivals/nearest.hpp"

namespace krait::rivals {

// As many levels as give at most one leaf for two points.
void NearestPoints::allocate(Arena& arena, const Scene& scene, std::uint32_t capacity) {
  std::int32_t side = 1;
  first_leaf_ = 0;
  for (int level = 0; level < kMaxLevels; ++level) {
    const std::uint32_t leaves = 4 * static_cast<std::uint32_t>(side * side);
    if (leaves > capacity / 2) break;
    side *= 2;
    first_leaf_ = 4 * first_leaf_ + 1;
  }
  const Box bounds = scene.bounds();
  const float width = bounds.max.x - bounds.min.x;
  const float height = bounds.max.y - bounds.min.y;
  grid_.origin = bounds.min;
  grid_.per_metre = static_cast<float>(side) / (width > height ? width : height);
  grid_.columns = side;
  grid_.rows = side;
  newest_ = arena.allocate<Index>(Pool::groups, node_count());
  next_ = arena.allocate<Index>(Pool::groups, capacity);
  points_ = arena.allocate<Vec2>(Pool::groups, capacity);
}

void NearestPoints::clear() {
  size_ = 0;
  for (std::uint32_t node = 0; node < node_count(); ++node) newest_[node] = kNone;
}

NearestPoints::Block NearestPoints::child(const Block& block, std::uint32_t quadrant) {
  const std::int32_t half = block.cells / 2;
  return {4 * block.node + 1 + quadrant, block.x + ((quadrant & 1U) != 0 ? half : 0),
          block.y + ((quadrant & 2U) != 0 ? half : 0), half};
}

void NearestPoints::insert(Vec2 point) {
  const Cell cell = grid_.cell(point);
  Block block{0, 0, 0, grid_.columns};
  while (block.node < first_leaf_) {
    newest_[block.node] = size_;
    const std::int32_t half = block.cells / 2;
    const std::uint32_t quadrant = (cell.column >= block.x + half ? 1U : 0U) + (cell.row >= block.y + half ? 2U : 0U);
    block = child(block, quadrant);
  }
  points_[size_] = point;
  next_[size_] = newest_[block.node];
  newest_[block.node] = size_++;
}

// Squared distance from p to the block, in cells; p is in cells as well. A little less than it is, since a point's cell
// and this are rounded.
float NearestPoints::squared_cells_to(const Block& block, Vec2 p) const {
  constexpr float kRounding = 0.01F;
  const auto outside = [](float x, std::int32_t first, std::int32_t count) {
    const auto low = static_cast<float>(first);
    const auto high = static_cast<float>(first + count);
    const float gap = (low - x > x - high ? low - x : x - high) - kRounding;
    return gap > 0.0F ? gap : 0.0F;
  };
  const float dx = outside(p.x, block.x, block.cells);
  const float dy = outside(p.y, block.y, block.cells);
  return dx * dx + dy * dy;
}

// Depth first, the quadrant of p before the others: never more than three blocks a level wait.
Index NearestPoints::nearest(Vec2 p) const {
  const Vec2 in_cells = grid_.per_metre * (p - grid_.origin);
  Block waiting[3 * kMaxLevels + 1] = {{0, 0, 0, grid_.columns}};
  int count = 1;
  Best best;
  while (count > 0) {
    const Block block = waiting[--count];
    const float reach = best.squared * grid_.per_metre * grid_.per_metre;
    if (newest_[block.node] == kNone || squared_cells_to(block, in_cells) > reach) continue;
    if (block.node >= first_leaf_) {
      search_list(newest_[block.node], p, best);
      continue;
    }
    const std::int32_t half = block.cells / 2;
    const std::uint32_t own = (in_cells.x >= static_cast<float>(block.x + half) ? 1U : 0U) +
                              (in_cells.y >= static_cast<float>(block.y + half) ? 2U : 0U);
    for (std::uint32_t i = 0; i < 4; ++i) waiting[count++] = child(block, own ^ (3 - i));
  }
  return best.point;
}

void NearestPoints::search_list(Index newest, Vec2 p, Best& best) const {
  for (Index i = newest; i != kNone; i = next_[i]) {
    const Vec2 apart = p - points_[i];
    const float squared = dot(apart, apart);
    if (squared > best.squared || (squared == best.squared && i > best.point)) continue;
    best = {squared, i};
  }
}

}  // namespace krait::rivals
