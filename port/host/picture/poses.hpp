// SPDX-License-Identifier: Apache-2.0
// Where a robot's bodies are in a state, for every model.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/robot_file/robot_file.hpp"

namespace krait::host {

struct Pose {
  double x = 0;  // metres
  double y = 0;
  double heading = 0;  // radians
};

// The number of values in a state. Throws InputError for a model that is not known.
std::size_t state_size(const RobotSpec& robot);

// One pose a body, body 0 first: the frame that robot.bodies[k] is given in. `state` has state_size values in the
// order of the plan's state_names. Trailer i's axle lies hitch_length behind the axle before it, along theta_i.
// Throws InputError if the model is not known or a trailer's hitch_length is missing.
std::vector<Pose> body_poses(const RobotSpec& robot, std::span<const float> state);

}  // namespace krait::host
