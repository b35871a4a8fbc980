// SPDX-License-Identifier: Apache-2.0
// Polygons of boxes and circles.
#pragma once

#include <initializer_list>

#include "host/input/json.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// Metres: the disc that stands for a goal where a file asks for one state.
inline constexpr double kStateGoalRadius = 0.1;

inline constexpr double kMinLength = 1e-6;  // m, of boxes and radii in files

// The box of a file that has a centre, a size and, under one of these names, an angle, radians, that turns it about its
// centre; without one it is 0. Counter-clockwise. Refuses an angle of more than a whole turn, which degrees most likely
// are.
Ring read_box(const Field& box, std::initializer_list<const char*> angle_names);

// Regular polygons of 8 to 128 corners, as few as keep within 1 cm of the circle.
Ring ring_around_circle(const Point& center, double radius);  // contains the circle
Ring ring_inside_circle(const Point& center, double radius);  // lies inside the circle

Goal pose_goal(const std::string& name, const GoalPose& pose);

}  // namespace krait::host
