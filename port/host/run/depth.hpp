// SPDX-License-Identifier: Apache-2.0
// How far a robot reaches into obstacles.
#pragma once

#include <vector>

#include "host/robot_file/robot_file.hpp"
#include "krait/scene.hpp"

namespace krait::host {

// The part of the ring that lies so deep, in metres, in the convex body, whose corners are counter-clockwise.
Ring deep_part(Ring ring, const Ring& body, double depth);

// Whether a body of the robot in this state has a point of an obstacle that lies so deep in it, in metres: then it also
// meets the obstacle that was grown by as much. O(pieces * bodies).
bool reaches_deeper(const RobotSpec& robot, const std::vector<float>& state, const krait::Scene& scene, double depth);

}  // namespace krait::host
