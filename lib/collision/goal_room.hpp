// SPDX-License-Identifier: Apache-2.0
// Whether a disc finds room in a goal.
#pragma once

#include "collision/obstacles.hpp"
#include "krait/goal.hpp"

namespace krait::detail {

struct GoalRoom {
  bool enough = false;  // false: it is proven that no point has that clearance
  float found = 0.0F;   // metres: the most clearance of a point that was looked at
  Vec2 at{};            // that point
};

// Whether a point within `reach` metres of the goal, or where that is below 0 so deep inside, may have a clearance of
// `enough` metres. By branch and bound over squares: at most 1,365 distances of a point, and one where the middle of
// the goal has enough.
GoalRoom goal_room(const Scene& scene, const Obstacles& obstacles, const Goal& goal, float reach, float enough);

}  // namespace krait::detail
