// SPDX-License-Identifier: Apache-2.0
// A rough step of a robot, cheap and near enough to tell where a target leads.
#pragma once

#include "krait/robot/robot_model.hpp"

namespace krait {

// Moves the state s and its frames `poses` by dt under u. False where it leaves the robot's limits. A robot may have it
// as sketch(s, poses, u, dt); else it is a step by the midpoint rule.
template <RobotModel R>
bool sketch(const R& robot, StateRef s, Pose* poses, ControlView u, float dt) {
  if constexpr (requires {
                  { robot.sketch(s, poses, u, dt) } -> std::same_as<bool>;
                }) {
    return robot.sketch(s, poses, u, dt);
  } else {
    const int n = robot.state_size();
    float rates[R::kMaxState];
    float middle[R::kMaxState];
    robot.derivative(StateView(s.data(), n), u, StateRef(rates, n));
    for (int i = 0; i < n; ++i) middle[i] = s[i] + 0.5F * dt * rates[i];
    robot.derivative(StateView(middle, n), u, StateRef(rates, n));
    for (int i = 0; i < n; ++i) s[i] = s[i] + dt * rates[i];
    if (!robot.within_limits(StateView(s.data(), n))) return false;
    robot.place(StateView(s.data(), n), poses);
    return true;
  }
}

}  // namespace krait
