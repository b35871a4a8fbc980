// SPDX-License-Identifier: Apache-2.0
// Whether discs are free: rough looks at where a robot may go. They choose what is tried, and prove nothing.
#pragma once

#include "krait/scene.hpp"

namespace krait::detail {

class Sight {
 public:
  // One that looks in a scene, which must outlive it, for discs of `radius` metres, at least 0, in steps of `step`
  // metres, above 0. Another looks nowhere until this is assigned to it.
  static Sight in(const Scene& scene, float radius, float step) {
    Sight sight;
    sight.scene_ = &scene;
    sight.radius_ = radius;
    sight.step_ = step;
    return sight;
  }

  // The same for discs of `radius` metres, at least 0.
  Sight of_radius(float radius) const {
    Sight sight = *this;
    sight.radius_ = radius;
    return sight;
  }
  float radius() const { return radius_; }

  // Metres that the disc around a point may move in any direction and is free all the way: by the clearance grid, and 0
  // where that does not suffice and the pieces nearby leave the disc free. Negative where the disc meets a piece, is
  // not within the bounds, or the point is not finite. Worst case: every edge of the pieces in the buckets that the
  // disc's box meets.
  float slack(Vec2 center) const {
    const float room = scene_->clearance().at(center) - radius_;
    return room > 0.0F ? room : slack_near(center);
  }

  // Whether a disc is free that goes straight from a to b, but for its first step, as far as some places on the way
  // show, none further than a step from the next that the grid does not tell about. False where kMostLooks do not reach
  // b.
  bool line_free(Vec2 a, Vec2 b) const;

  static constexpr int kMostLooks = 200;  // measured: bench/ABLATIONS.md, "Constants"

 private:
  // slack() where the grid alone does not decide it.
  float slack_near(Vec2 center) const;

  bool apart_from_pieces(Vec2 center) const;

  const Scene* scene_;
  float radius_;
  float step_;
};

}  // namespace krait::detail
