// SPDX-License-Identifier: Apache-2.0
// What a state must be for a plan to end with it: in the goal, turned as a pose requires, and no faster than end_speed.
#pragma once

#include "krait/goal.hpp"
#include "krait/robot.hpp"

namespace krait::detail {

inline constexpr float kRestSpeed = 5e-3F;  // m/s: as much faster than end_speed still counts as no faster

class Ending {
 public:
  // Robot and scene must outlive this. The plan ends with at most `speed` m/s, infinite: any.
  void assign(const Robot& robot, const Scene& scene, const Goal& goal, float speed);

  const Goal& goal() const { return goal_; }

  // Whether a robot may have to brake.
  bool limits_speed() const { return robot_.has_speed() && most_ < kInfinity; }

  // Whether a plan may end with the state, whose position must lie `depth` metres inside the goal, and whose headings a
  // radian for each of them inside a pose's tolerances, at most a tenth of those.
  bool holds(const float* state, float depth) const;

  // Whether the state is no faster than end_speed.
  bool slow(const float* state) const { return !limits_speed() || robot_.speed(state) <= most_; }

  // Whether a robot that is too fast in the state, its body 0 at `pose`, would come to rest in the goal by braking,
  // by its stopping way.
  bool stops_inside(const float* state, const Pose& pose) const;

 private:
  static constexpr float kMostInside = 0.1F;  // of a tolerance

  // Whether the bodies are turned as a pose requires.
  bool faces(const float* state, float inside) const;

  static bool within(float angle, float tolerance, float inside);

  Robot robot_;
  const Scene* scene_ = nullptr;
  Goal goal_ = Goal::named(0);
  float most_ = kInfinity;  // m/s
};

}  // namespace krait::detail
