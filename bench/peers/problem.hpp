// SPDX-License-Identifier: Apache-2.0
// The problem that OMPL's planners solve: our robot, scene, goal and parameters behind OMPL's interfaces.
#pragma once

#include <ompl/base/State.h>

#include "host/rivals/rival.hpp"
#include "krait/krait.hpp"
#include "peers/peer_robot.hpp"

namespace krait::bench {

// How a control of OMPL's planners moves the robot.
enum class ControlKind {
  pid,    // a control is a target point and speed, which our controller steers to in every step
  random  // a control is the robot's own, held over many steps, within what keeps speed and steering in their limits
};

// Where a control ends before its time: a further step counts as invalid.
enum class Stop { never, in_goal };

// What a planner of OMPL's can be tuned by; not every planner has all of them.
struct PeerTuning {
  double goal_bias = 0.05;                  // OMPL's own default: the share of targets that are the goal
  double max_steps = 40;                    // a control is held for 1 to that many steps
  double slowest = rivals::kRivalsSlowest;  // speeds are uniform from this share of the top speed to all of it
  double stop_at_target = 0;                // 1: a control that steers to a target ends near it as well
  double gentle_share = 0;                  // of the controls that turn gently, as a share of krait's own do
  double heading_weight = 0;                // metres that a radian counts in PeerSpace's distance
  double rest_weight = 0;                   // metres that a unit of any other component counts there
  double range = 20;                        // m, EST samples so near
  double selection_radius = 1;              // m, SST's
  double pruning_radius = 0.3;              // m, SST's
  double cells_a_side = 32;                 // of a grid, Syclop's
  double cell_lengths = 1;  // side of a cell of the projection, in lengths of the robot: KPIECE1's, EST's
};

// Everything outlives the planners that use it. Coordinates are the scene's own.
struct PeerProblem {
  const PeerRobot& robot;
  const Scene& scene;
  Goal goal;
  float goal_depth;  // metres inside the goal where a plan may end
  Parameters parameters;
  ControlKind controls;
  PeerTuning tuning;
};

inline bool in_goal(const PeerProblem& problem, Vec2 at) {
  return problem.goal.contains(problem.scene, at, problem.goal_depth);
}

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

  float values[kMaxState];
  std::uint64_t origin;  // kSampled, kAssumed, or the number of the step that ends here

  Vec2 position() const { return {values[0], values[1]}; }
};

inline PeerState& peer(ompl::base::State* state) { return *state->as<PeerState>(); }
inline const PeerState& peer(const ompl::base::State* state) { return *state->as<PeerState>(); }

}  // namespace krait::bench
