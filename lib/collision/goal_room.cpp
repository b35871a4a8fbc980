// SPDX-License-Identifier: Apache-2.0
#include "collision/goal_room.hpp"

#include <algorithm>

namespace krait::detail {
namespace {

constexpr int kDeepest = 5;  // how often squares are quartered; measured: bench/ABLATIONS.md, "Constants"
constexpr float kDiagonal = 1.4142136F;

struct Square {
  Vec2 center;
  float half;  // of a side
  int depth;
};

Square around(const Box& box, float reach) {
  const Vec2 size = box.max - box.min;
  return {0.5F * (box.min + box.max), 0.5F * std::max(size.y, size.x) + reach, 0};
}

}  // namespace

// The clearance changes by no more than the point moves: its Lipschitz constant is 1. So no point of a square has more
// than that of the centre and half a diagonal together. A square whose bound is too low is left out, others are
// quartered.
GoalRoom goal_room(const Scene& scene, const Obstacles& obstacles, const Goal& goal, float reach, float enough) {
  GoalRoom room;
  Square squares[3 * kDeepest + 1] = {around(goal.box(scene), reach)};
  for (int remaining = 1; remaining > 0 && !room.enough;) {
    const Square square = squares[--remaining];
    const float radius = kDiagonal * square.half;
    if (!goal.near(scene, square.center, reach + radius)) continue;
    const float clearance = obstacles.distance(square.center, enough + radius);
    if (clearance > room.found && goal.near(scene, square.center, reach)) {
      room.found = clearance;
      room.at = square.center;
    }
    const float most = clearance + radius;  // of any point of the square
    const bool undecided = square.depth == kDeepest && most >= enough;
    room.enough = room.found >= enough || undecided;
    if (most <= room.found || square.depth == kDeepest) continue;
    const float half = 0.5F * square.half;
    for (int i = 0; i < 4; ++i) {
      const Vec2 aside{(i & 1) == 0 ? half : -half, (i & 2) == 0 ? half : -half};
      squares[remaining++] = {square.center + aside, half, square.depth + 1};
    }
  }
  return room;
}

}  // namespace krait::detail
