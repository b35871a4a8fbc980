// SPDX-License-Identifier: Apache-2.0
// Measures of a robot's bodies, and whether they can be used.
#pragma once

#include "krait/geometry.hpp"
#include "krait/robot.hpp"
#include "krait/status.hpp"

namespace krait::detail {

inline constexpr float kMaxExtent = 100.0F;  // metres, of a vertex from its body's origin

// 3 to 8 finite vertices, strictly convex, counter-clockwise, no side shorter than 0.1 mm, within kMaxExtent.
bool usable_body(Polygon body);

// Radius of the largest disc around `center` that lies in the body; 0 when the centre is outside.
float inner_radius(Polygon body, Vec2 center);

// The middle of a body's vertices: the best centre for a disc in a box.
Vec2 middle(Polygon body);

// Argument::none, or what makes the robot unusable.
Argument first_bad_of_robot(const Robot& robot);

// Whether a dimension or a limit that cannot be 0 is usable.
inline bool positive(float x) { return x > 0.0F && finite(x); }

// Largest distance of `count` points from the origin.
inline float farthest(const Vec2* points, int count) {
  float most = 0.0F;
  for (int i = 0; i < count; ++i) {
    const float distance = length(points[i]);
    if (distance > most) most = distance;
  }
  return most;
}

// Length of a body along its x axis, metres.
float body_length(Polygon body);

// Length of body 0 along its x axis, metres: the unit of parameters that are in robot lengths.
float robot_length(const Robot& robot);

}  // namespace krait::detail
