// SPDX-License-Identifier: Apache-2.0
// What a state must be for a plan to end with it: in the goal, and no faster than asked.
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

  // Whether a plan may end with the state, whose position must lie `depth` metres inside the goal.
  bool holds(const float* state, float depth) const {
    return slow(state) && goal_.contains(*scene_, {state[0], state[1]}, depth);
  }

  // Whether the state is no faster than asked.
  bool slow(const float* state) const { return !limits_speed() || speed_of(*robot_, view(state)) <= most_; }

  // Whether a robot that is too fast in the state, its body 0 at `pose`, would come to rest in the goal by braking, as
  // far as its stopping way tells.
  bool stops_inside(const float* state, const Pose& pose) const {
    if (slow(state)) return false;
    const Vec2 along{pose.heading.cos, pose.heading.sin};
    return goal_.contains(*scene_, pose.position + stopping_way(*robot_, view(state)) * along, 0.0F);
  }

 private:
  StateView view(const float* state) const { return {state, robot_->state_size()}; }

  const R* robot_ = nullptr;
  const Scene* scene_ = nullptr;
  Goal goal_ = Goal::named(0);
  float most_ = kInfinity;  // m/s
};

}  // namespace krait
