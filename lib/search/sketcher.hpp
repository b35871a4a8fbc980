// SPDX-License-Identifier: Apache-2.0
// How far a target leads before the robot would hit something, as far as a coarse roll-out shows in which bodies are
// discs.
#pragma once

#include "base/arena.hpp"
#include "collision/sight.hpp"
#include "robot/shape.hpp"

namespace krait::detail {

class Sketcher {
 public:
  static constexpr std::uint32_t kSteps = 20;  // at most; measured: bench/ABLATIONS.md, "Constants"

  // 36 bytes a body and 4 a component of the state. Uninitialised: assign comes before all else.
  void allocate(Arena& arena, const Robot& robot);

  // Robot, of the sizes that memory was allocated for, and scene must outlive this. Steps are of dt seconds; a target
  // is reached within `near` metres.
  void assign(const Robot& robot, const Scene& scene, float dt, float near);

  // Metres: the radius of the discs around the bodies' middles that lie in all of them.
  float radius() const { return radius_; }

  // The steps from `state` toward the target after which the discs, a little larger, are still free; kSteps where they
  // are until the target is reached, too.
  std::uint32_t free_steps(const float* state, const Target& toward);

 private:
  static constexpr float kRoom = 1.08F;  // of the disc in a body; measured, too

  // The place at which a disc was looked at last, and the square of what it may move from there.
  struct Look {
    Vec2 center;
    float squared_slack;
  };

  void begin(const float* state);

  bool free();

  Robot robot_;
  float dt_;
  float squared_near_;
  float radius_;
  Sight sight_;
  float* state_;  // since allocate, as what follows
  // These have an element for each body.
  Vec2* centers_;  // in its frame
  Pose* poses_;
  Look* looks_;
  Steering steering_;
};

}  // namespace krait::detail
