// SPDX-License-Identifier: Apache-2.0
#include "plan/ending.hpp"

#include <algorithm>

namespace krait::detail {

void Ending::assign(const Robot& robot, const Scene& scene, const Goal& goal, float speed) {
  robot_ = robot;
  scene_ = &scene;
  goal_ = goal;
  most_ = speed + kRestSpeed;
}

bool Ending::holds(const float* state, float depth) const {
  return slow(state) && goal_.contains(*scene_, {state[0], state[1]}, depth) && faces(state, depth);
}

bool Ending::stops_inside(const float* state, const Pose& pose) const {
  if (slow(state)) return false;
  const Vec2 along{pose.heading.cos, pose.heading.sin};
  const Vec2 end = pose.position + robot_.stopping_way(state) * along;
  return goal_.contains(*scene_, end, 0.0F) && faces(state, 0.0F);
}

bool Ending::faces(const float* state, float inside) const {
  if (!goal_.is_pose()) return true;
  const Facing& facing = goal_.facing();
  Pose poses[kMaxBodies];
  robot_.place(state, poses);
  const float off = angle_between(poses[0].heading, math::sin_cos(facing.heading));
  const bool turned = facing.either_way && off > 0.5F * kPi ? within(kPi - off, facing.tolerance, inside)
                                                            : within(off, facing.tolerance, inside);
  if (!turned || facing.hitches == kInfinity) return turned;
  for (int k = 1; k < robot_.body_count(); ++k) {
    if (!within(angle_between(poses[k - 1].heading, poses[k].heading), facing.hitches, inside)) return false;
  }
  return true;
}

bool Ending::within(float angle, float tolerance, float inside) {
  if (tolerance >= kPi) return true;
  const float least = kMostInside * tolerance;
  return angle <= tolerance - std::min(least, inside);
}

}  // namespace krait::detail
