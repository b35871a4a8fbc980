// SPDX-License-Identifier: Apache-2.0
// A robot of any model for OMPL's planners: the core's, and what they need to know of it that the core does not ask.
#pragma once

#include <vector>

#include "host/run/robots.hpp"

namespace krait::bench {

// One number of a robot's control.
struct ControlAxis {
  float low;  // the control's limits, in its unit
  float high;
  int component = -1;  // of the state, whose rate of change the control is; -1: of none, it acts at once
  float least = 0;     // that component's limits
  float most = 0;
  bool drives = false;  // whether the robot drives straight ahead at its top speed where the component is at its most
};

class PeerRobot {
 public:
  explicit PeerRobot(const host::RobotSpec& spec);

  // Refers to this.
  Robot core() const { return robot_.view(); }
  // One for each number of a control.
  const std::vector<ControlAxis>& axes() const { return axes_; }
  // Metres: the width of the widest disc around body 0's origin that lies in the body.
  float width() const;

  // Writes the control that steers `state` toward the target. The controller starts afresh at every call.
  void steer(const float* state, const Target& target, float* control) const;
  // Writes the state in which the bodies stand in a line, and drive straight ahead at a share of the top speed where
  // the state has a speed.
  void drive_straight(Vec2 at, float heading, float speed_share, float* state) const;

 private:
  host::CoreRobot robot_;
  std::vector<ControlAxis> axes_;
};

}  // namespace krait::bench
