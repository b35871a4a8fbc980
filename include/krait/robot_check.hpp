// SPDX-License-Identifier: Apache-2.0
/// \file
/// Holds a robot of one's own to what the RobotModel concept requires of it (krait/robots/model.hpp), before it plans:
/// against its own derivative, integrated finely in double precision. For hosts: not part of krait.hpp, with the
/// standard library, in an archive of its own (krait::robot_check).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "krait/parameters.hpp"
#include "krait/robot.hpp"

namespace krait {

/// A promise that a function of a robot does not keep, in the worst case that was found. It owns its texts.
struct RobotFault {
  std::string function;  ///< the name of the function, such as travel
  std::string promise;   ///< a short name of what it promises, such as path
  std::string message;   ///< what, by how much, at which state and control, and what to do
  double amount = 0;     ///< how far off it is, in the promise's own unit; infinite where that is unknown
  int samples = 0;       ///< in how many it was found; 0: it is of no sample, but of the check as a whole
};

/// What check_robot has found. It owns everything in it.
struct RobotReport {
  std::vector<RobotFault> faults;  ///< one a broken promise; empty where none was found
  int samples = 0;                 ///< that were looked at

  /// Whether no broken promise was found. O(1).
  bool ok() const { return faults.empty(); }

  /// A line for each fault; empty where there is none. O(length of the text).
  std::string text() const;
};

/// The range of a component, which includes both ends. They and their difference are finite.
struct RobotRange {
  float low;   ///< in the component's own unit
  float high;  ///< in the component's own unit, not below low
};

/// Where a robot's states and controls lie, in its own units, and what holds of it. Where they do not fit the robot's
/// sizes, or one of them is not as stated here, check_robot draws nothing and reports a fault of the function `ranges`.
/// So it does where the motion was checked in fewer than a tenth of a time step's samples, since in the others no
/// control that it drew ends the step within the limits.
struct RobotRanges {
  std::vector<RobotRange> state;    ///< one a component; drawn evenly, but for the position now and then at the ends
  std::vector<RobotRange> control;  ///< one a component: the limits that steer keeps to; drawn in the same way
  std::vector<float> dt = {Parameters().dt};  ///< seconds, finite and above 0: the time steps to be tried
  /// The components of the state that are headings, in radians: turning the robot adds to them and changes nothing else
  /// but the position. Whether it moves alike in every direction is checked where there are any.
  std::vector<int> headings = {};
  bool translation_invariant = true;  ///< whether it moves alike wherever it stands, which is checked then
  float leaving_share = 0.0F;  ///< 0 … 1: share of steered steps that may leave the limits, as where hitches fold
  // A Runge-Kutta step of step_rate / fastest_rate(dt) seconds, and at most dt, is to be accurate to step_error, in
  // metres and radians: as the library makes them while the tree grows (lib/DESIGN.md, "Integration", which is
  // installed below share/doc/krait).
  float step_rate = 0.32F;   ///< finite, 0 or more, without a unit; 0: not checked
  float step_error = 5e-4F;  ///< metres and radians, finite, 0 or more
  /// Makes a state of the numbers that were drawn, where components depend on each other; none: they are the state.
  std::function<void(std::vector<float>& state)> complete_state = {};
};

/// Draws `samples` states and controls from the ranges and reports every promise of the concept that the robot breaks
/// at one of them, with the worst case found. Returns the same report for the same seed. An empty report is no proof.
/// Throws nothing but std::bad_alloc, and what ranges.complete_state throws. Work: some thousand derivatives a sample.
[[nodiscard]] RobotReport check_robot(const Robot& robot, const RobotRanges& ranges, int samples = 1000,
                                      std::uint64_t seed = 1);

}  // namespace krait
