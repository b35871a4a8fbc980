// SPDX-License-Identifier: Apache-2.0
// Measures of a robot's bodies, and whether they can be used.
#pragma once

#include "krait/robot/box.hpp"
#include "krait/robot/robot.hpp"
#include "krait/status.hpp"

namespace krait {

// 3 to 8 finite vertices, strictly convex, counter-clockwise, no side shorter than 0.1 mm, within 100 m.
bool usable_body(Polygon body);

// Radius of the largest disc around `center` that lies in the body; 0 when the centre is outside.
float inner_radius(Polygon body, Vec2 center);

// The middle of a body's vertices: the best centre for a disc in a box.
Vec2 middle(Polygon body);

// Argument::none, or what makes the robot unusable.
template <Robot R>
Argument first_bad_of_robot(const R& robot) {
  if (!sound(robot)) return Argument::robot_dimensions;
  const bool sizes = robot.state_size() >= 2 && robot.state_size() <= R::kMaxState && robot.control_size() >= 1 &&
                     robot.control_size() <= R::kMaxControl && robot.body_count() >= 1 &&
                     robot.body_count() <= R::kMaxBodies;
  if (!sizes) return Argument::robot_sizes;
  for (int k = 0; k < robot.body_count(); ++k) {
    if (!usable_body(robot.body(k))) return Argument::robot_polygon;
  }
  return Argument::none;
}

// Length of body 0 along its x axis, metres: the unit of parameters given in robot lengths.
template <Robot R>
float robot_length(const R& robot) {
  const Polygon body = robot.body(0);
  float low = body[0].x;
  float high = body[0].x;
  for (int i = 1; i < body.count; ++i) {
    if (body[i].x < low) low = body[i].x;
    if (body[i].x > high) high = body[i].x;
  }
  return high - low;
}

}  // namespace krait
