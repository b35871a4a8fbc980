// SPDX-License-Identifier: Apache-2.0
// The nearest of the points inserted so far, exactly, in fixed memory: a full quadtree over the workspace whose leaves
// are square cells, each with a linked list of its points.
#pragma once

#include "base/arena.hpp"
#include "host/rivals/rival.hpp"
#include "krait/scene.hpp"

namespace krait::rivals {

class NearestPoints {
 public:
  // For `capacity` points inside the scene's bounds: 12 bytes a point, and 1 to 3 for the tree.
  void allocate(Arena& arena, const Scene& scene, std::uint32_t capacity);

  // No points. O(capacity).
  void clear();

  // Point number size(). Inside the bounds; at most as many as there is room for. O(kMaxLevels).
  void insert(Vec2 point);

  // The number of the point with the least distance to p, computed in float; the lowest number among equals; kNone
  // without points. p is finite. O(kMaxLevels + points of some cells) unless most points lie equally far, O(size) then.
  Index nearest(Vec2 p) const;

  std::uint32_t size() const { return size_; }

 private:
  static constexpr int kMaxLevels = 10;  // below the root

  // Children of node n are 4 n + 1 … 4 n + 4. `x` and `y` are those of its first cell, `cells` the length of its side.
  struct Block {
    std::uint32_t node;
    std::int32_t x;
    std::int32_t y;
    std::int32_t cells;
  };

  struct Best {
    float squared = kInfinity;
    Index point = kNone;
  };

  std::uint32_t node_count() const { return 4 * first_leaf_ + 1; }
  static Block child(const Block& block, std::uint32_t quadrant);
  float squared_cells_to(const Block& block, Vec2 p) const;
  void search_list(Index newest, Vec2 p, Best& best) const;

  CellGrid grid_;  // of the leaves
  std::uint32_t first_leaf_ = 0;
  Index* newest_ = nullptr;  // by node: the newest point below it
  Index* next_ = nullptr;    // by point: the one before it in its cell
  Vec2* points_ = nullptr;
  std::uint32_t size_ = 0;
};

}  // namespace krait::rivals
