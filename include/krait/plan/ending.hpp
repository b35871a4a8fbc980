// SPDX-License-Identifier: Apache-2.0
// What a state must be for a plan to end with it: in the goal, turned as a pose asks, and no faster than asked.
#pragma once

#include "krait/decomposition/goal.hpp"
#include "krait/robot/robot.hpp"

namespace krait {

inline constexpr float kRestSpeed = 5e-3F;  // m/s: as much faster than asked still counts as no faster

template <Robot R>
class Ending {
 public:
  // Robot and scene must outlive this. The plan ends with at most `speed` m/s, infinite: any.
  void assign(const R& robot, const Scene& scene, const Goal& goal, float speed) {
    robot_ = &robot;
    scene_ = &scene;
    goal_ = goal;
    most_ = speed + kRestSpeed;
  }

  const Goal& goal() const { return goal_; }

  // Whether a robot may have to brake.
  bool limits_speed() const { return kHasSpeed<R> && most_ < kInfinity; }

  // Whether a plan may end with the state, whose position must lie `depth` metres inside the goal, and whose headings a
  // radian for each of them inside a pose's tolerances, at most a tenth of those.
  bool holds(const float* state, float depth) const {
    return slow(state) && goal_.contains(*scene_, {state[0], state[1]}, depth) && faces(state, depth);
  }

  // Whether the state is no faster than asked.
  bool slow(const float* state) const { return !limits_speed() || speed_of(*robot_, view(state)) <= most_; }

  // Whether a robot that is too fast in the state, its body 0 at `pose`, would come to rest in the goal by braking, as
  // far as its stopping way tells.
  bool stops_inside(const float* state, const Pose& pose) const {
    if (slow(state)) return false;
    const Vec2 along{pose.heading.cos, pose.heading.sin};
    const Vec2 end = pose.position + stopping_way(*robot_, view(state)) * along;
    return goal_.contains(*scene_, end, 0.0F) && faces(state, 0.0F);
  }

 private:
  static constexpr float kMostInside = 0.1F;  // of a tolerance

  StateView view(const float* state) const { return {state, robot_->state_size()}; }

  // Whether the bodies are turned as a pose asks.
  bool faces(const float* state, float inside) const {
    if (!goal_.is_pose()) return true;
    const Facing& facing = goal_.facing();
    Pose poses[R::kMaxBodies];
    robot_->place(view(state), poses);
    const float off = angle_between(poses[0].heading, sin_cos(facing.heading));
    const bool turned = facing.either_way && off > 0.5F * kPi ? within(kPi - off, facing.tolerance, inside)
                                                              : within(off, facing.tolerance, inside);
    if (!turned || facing.hitches == kInfinity) return turned;
    for (int k = 1; k < robot_->body_count(); ++k) {
      if (!within(angle_between(poses[k - 1].heading, poses[k].heading), facing.hitches, inside)) return false;
    }
    return true;
  }

  static bool within(float angle, float tolerance, float inside) {
    if (tolerance >= kPi) return true;
    const float least = kMostInside * tolerance;
    return angle <= tolerance - (inside < least ? inside : least);
  }

  const R* robot_ = nullptr;
  const Scene* scene_ = nullptr;
  Goal goal_ = Goal::named(0);
  float most_ = kInfinity;  // m/s
};

}  // namespace krait
