// SPDX-License-Identifier: Apache-2.0
// Which states may end a plan.
#pragma once

#include "krait/decomposition/goal.hpp"

namespace krait {

class PlanEnd {
 public:
  PlanEnd() = default;

  // `margin` metres, or a tenth of the goal's size if that is less, is how deep inside the goal ways end.
  PlanEnd(const Scene& scene, const Goal& goal, float margin) : scene_(&scene), goal_(goal) {
    const float tenth = 0.1F * goal.size(scene);
    depth_ = margin < tenth ? margin : tenth;
  }

  // Whether a way may end with this state while it is searched.
  bool reached(const float* state) const { return contains(state, depth_); }
  // Whether the plan that is driven beside it may.
  bool kept(const float* state) const { return contains(state, kDepthKept * depth_); }
  // Whether a start at this state needs no plan.
  bool standing(const float* state) const { return contains(state, 0.0F); }

 private:
  static constexpr float kDepthKept = 0.1F;  // share of the goal's margin that a plan keeps

  bool contains(const float* state, float depth) const { return goal_.contains(*scene_, {state[0], state[1]}, depth); }

  const Scene* scene_ = nullptr;
  Goal goal_ = Goal::named(0);
  float depth_ = 0.0F;
};

}  // namespace krait
