// SPDX-License-Identifier: Apache-2.0
// What OMPL's planners are asked: our robot, scene, goal and parameters behind OMPL's interfaces.
#pragma once

#include <ompl/base/State.h>

#include "krait/krait.hpp"

namespace krait::bench {

// How a control of OMPL's planners moves the robot.
enum class ControlKind {
  pid,    // a control is a target point and speed, which our controller steers to in every step
  random  // a control is the robot's own, held over many steps, within what keeps speed and steering in their limits
};

// Where a control ends before its time: a further step counts as invalid.
enum class Stop {
  never,
  in_goal,
  at_target  // and in the goal
};

// Everything outlives the planners that use it. Coordinates are the scene's own.
struct PeerProblem {
  const Snake& robot;
  const Scene& scene;
  Goal goal;
  float goal_depth;  // metres inside the goal where a plan may end
  Parameters parameters;
  ControlKind controls;
};

inline bool in_goal(const PeerProblem& problem, Vec2 at) {
  return problem.goal.contains(problem.scene, at, problem.goal_depth);
}

inline constexpr double kGoalBias = 0.05;  // OMPL's own default

inline Box goal_box(const PeerProblem& problem) {
  const Vec2 reach{problem.goal.radius(), problem.goal.radius()};
  if (problem.goal.is_disc()) return {problem.goal.center() - reach, problem.goal.center() + reach};
  return bounding_box(problem.scene.goal_polygon(problem.goal.index()));
}

inline Vec2 goal_center(const PeerProblem& problem) {
  const Box box = goal_box(problem);
  return 0.5F * (box.min + box.max);
}

// A state as OMPL's planners keep it.
struct PeerState : ompl::base::State {
  static constexpr std::uint64_t kSampled = 0;
  static constexpr std::uint64_t kAssumed = ~std::uint64_t{0};  // valid without a check: samples of the goal

  float values[Snake::kMaxState];
  std::uint64_t origin;  // kSampled, kAssumed, or the number of the step that ends here

  Vec2 position() const { return {values[0], values[1]}; }
};

inline PeerState& peer(ompl::base::State* state) { return *state->as<PeerState>(); }
inline const PeerState& peer(const ompl::base::State* state) { return *state->as<PeerState>(); }

}  // namespace krait::bench
