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
  std::string message;   ///< what is wrong, by how much, at which state and control, and what to do
  double amount = 0;     ///< by how much it is broken, in the promise's own unit; infinite where that is unknown
  int samples = 0;       ///< the number of samples that showed it; 0: it concerns the check as a whole, no sample
};

/// What check_robot has found. It owns everything in it.
struct RobotReport {
  std::vector<RobotFault> faults;  ///< one for each broken promise; empty where none was found
  int samples = 0;                 ///< the number of samples that were checked

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

/// The ranges of a robot's states and controls, in its own units, and what else check_robot must know of it. If the
/// ranges do not fit the robot's sizes, or a number here is not as its comment says, check_robot draws no sample and
/// reports a fault of the function `ranges`. It also reports such a fault if it could check the motion in fewer than a
/// tenth of the samples of a time step: in the other samples, no control that it drew ended the step within the limits.
struct RobotRanges {
  /// One for each component. Samples are uniform in it; except for the position, some are at its ends.
  std::vector<RobotRange> state;
  /// One for each component: the limits that steer keeps to. Samples are drawn in the same way.
  std::vector<RobotRange> control;
  std::vector<float> dt = {Parameters().dt};  ///< seconds, finite and above 0: the time steps to be tried
  /// The components of the state that are headings, in radians: to turn the whole robot changes only these, by the
  /// angle, and the position. If there are any, check_robot checks that the robot moves in the same way in every
  /// direction.
  std::vector<int> headings = {};
  bool translation_invariant = true;  ///< whether to check that the robot moves in the same way at every position
  float leaving_share = 0.0F;  ///< 0 … 1: share of steered steps that may leave the limits, as when hitches fold
  // A Runge-Kutta step of step_rate / fastest_rate(dt) seconds, but of at most dt, must be accurate to step_error, in
  // metres and radians. The defaults are what the library requires of a step while the tree grows (lib/DESIGN.md,
  // "Integration", which is installed below share/doc/krait).
  float step_rate = 0.32F;   ///< finite, 0 or more, no unit; 0: not checked
  float step_error = 5e-4F;  ///< metres and radians, finite, 0 or more
  /// Turns the numbers that were drawn into a state, for a robot whose components depend on each other. Without it the
  /// numbers are the state.
  std::function<void(std::vector<float>& state)> complete_state = {};
};

/// Draws `samples` states and controls from the ranges and reports every promise of the concept that the robot breaks
/// at one of them, with the worst case found. Returns the same report for the same seed. An empty report is no proof.
/// Throws nothing but std::bad_alloc, and what ranges.complete_state throws. Work: some thousand derivatives a sample.
[[nodiscard]] RobotReport check_robot(const Robot& robot, const RobotRanges& ranges, int samples = 1000,
                                      std::uint64_t seed = 1);

}  // namespace krait
