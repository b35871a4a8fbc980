// SPDX-License-Identifier: Apache-2.0
// Polygons of boxes and circles.
#pragma once

#include "host/input/json.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// Metres: the disc that stands for a goal where a file asks for one state.
inline constexpr double kStateGoalRadius = 0.1;

// Counter-clockwise; the angle in radians turns the box about its centre.
Ring box_ring(const Point& center, double width, double height, double angle);

// The angle of a box in a file, radians. Refuses more than a whole turn, which degrees most likely are.
double box_angle(const Field& field);

// Regular polygons of 8 to 128 corners, as few as keep within 1 cm of the circle.
Ring ring_around_circle(const Point& center, double radius);  // contains the circle
Ring ring_inside_circle(const Point& center, double radius);  // lies inside the circle

Goal pose_goal(const std::string& name, const GoalPose& pose);

}  // namespace krait::host
