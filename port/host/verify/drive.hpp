// SPDX-License-Identifier: Apache-2.0
// The motion that a plan's controls lead to, followed so finely that the hulls of consecutive poses cover it.
#pragma once

#include <optional>
#include <vector>

#include "host/verify/dynamics.hpp"

namespace krait::host {

using Pose = std::vector<Frame>;  // one frame a body

// The motion under one control.
struct Leg {
  std::vector<State> states;  // at equal times, both ends included
  std::vector<Pose> poses;    // of each state
  double stray = 0;           // m, how far a body strays from the hulls of consecutive poses
};

class Drive {
 public:
  // Keeps references.
  Drive(const RobotSpec& robot, const Dynamics& dynamics);

  // The motion of `time` seconds from a finite state. Sub-steps are halved, down to time / 16384, until a body strays
  // from the hulls by at most 2e-5 m, no angle changes by more than 0.5 rad in one, and the end changes by at most
  // 1e-9 a component, and rounding, when they are halved once more; what is left of the truncation error is some
  // hundredth of that.
  // Returns nothing where that is not reached.
  std::optional<Leg> leg(const State& from, const Control& control, double time) const;

 private:
  Leg cut(const State& from, const Control& control, double time, std::size_t count) const;
  double most_turn(const State& from, const State& to) const;
  double stray(const std::vector<Pose>& poses) const;
  double relative_bend(const Pose& before, const Pose& middle, const Pose& after) const;

  const RobotSpec& robot_;
  const Dynamics& dynamics_;
  std::vector<double> radii_;  // of each body around its frame's origin
};

}  // namespace krait::host
