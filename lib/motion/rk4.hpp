// SPDX-License-Identifier: Apache-2.0
// MOTION (Eqn 2): fourth-order Runge-Kutta with the control held. A time step is divided into as many equal
// Runge-Kutta steps as keep the local error bounded (lib/DESIGN.md, "Integration").
#pragma once

#include <cstdint>

#include "krait/robot.hpp"

namespace krait::detail {

// A Runge-Kutta step of h seconds is accurate enough where h times the robot's fastest rate is at most this: while the
// tree grows; where a plan with trailers is driven, which follow and forget; and where errors stay or grow.
inline constexpr float kStepRate = 0.32F;
inline constexpr float kPlanStepRate = 0.16F;
inline constexpr float kFinePlanStepRate = 0.05F;

// The most Runge-Kutta steps of a time step: while the tree grows, init refuses what would need more; in a plan.
inline constexpr int kMostParts = 16;
inline constexpr int kMostPlanParts = 103;

// How many equal parts of `whole`, which is positive, are at most `longest` each; 1 or more, `most` at most.
inline int parts_of(float whole, float longest, int most) {
  int parts = 1;
  while (parts < most && static_cast<float>(parts) * longest < whole) ++parts;
  return parts;
}

// The longest Runge-Kutta step in seconds of time steps of dt, infinite for a robot that does not state its rate; not
// above 0 where the rate is none that can_integrate accepts.
float longest_step(const Robot& robot, float dt, float step_rate);
float longest_tree_step(const Robot& robot, float dt);
float longest_plan_step(const Robot& robot, float dt);

// Whether time steps of dt seconds need at most kMostParts.
bool can_integrate(const Robot& robot, float dt);

// The longest time step of at least 0.001 s and at most dt that needs at most kMostParts; 0 where there is none. At
// most 25 evaluations of the robot's fastest rate.
float longest_time_step(const Robot& robot, float dt);

// A Runge-Kutta step of dt seconds, whose leading components may be known before the rest.
class Motion {
 public:
  // Computes where the step leads, as far as integrate_lead does; `next` may not overlap `state`, whose frames are
  // `poses`.
  void lead(const Robot& robot, const float* state, const Pose* poses, const float* control, float dt, float* next);

  // Computes the rest of it; the arguments must be the same.
  void follow(const Robot& robot, const float* state, const Pose* poses, float dt, float* next) const;

 private:
  static int first_of_rest(const Robot& robot) { return robot.leads() ? robot.leading_size() : robot.state_size(); }

  Lead lead_;
};

// next = the state after one Runge-Kutta step of dt seconds; `next` may not overlap `state`, whose frames are `poses`.
void propagate(const Robot& robot, const float* state, const Pose* poses, const float* control, float dt, float* next);

// The same where the frames have yet to be found.
void propagate(const Robot& robot, const float* state, const float* control, float dt, float* next);

// next = the state after dt seconds in `parts` >= 1 equal Runge-Kutta steps; the rest as propagate.
void propagate_in_parts(const Robot& robot, const float* state, const Pose* poses, const float* control, float dt,
                        int parts, float* next);

}  // namespace krait::detail
