// SPDX-License-Identifier: Apache-2.0
#include "robot/shape.hpp"

#include <algorithm>

namespace krait::detail {
namespace {

constexpr float kLeastSide = 1e-4F;  // metres

// Distance of p to the left of the line from a to b; negative on its right.
float distance_left(Vec2 a, Vec2 b, Vec2 p) { return cross(b - a, p - a) / length(b - a); }

}  // namespace

bool usable_body(Polygon body) {
  if (body.vertices == nullptr || body.count < kMinVertices || body.count > kMaxVertices) {
    return false;
  }
  for (int i = 0; i < body.count; ++i) {
    if (!finite(body[i]) || !(length(body[i]) <= kMaxExtent)) return false;
  }
  for (int i = 0; i < body.count; ++i) {
    const Vec2 a = body[i];
    const Vec2 b = body[(i + 1) % body.count];
    if (!(length(b - a) >= kLeastSide)) return false;
    for (int j = 2; j < body.count; ++j) {
      if (!(distance_left(a, b, body[(i + j) % body.count]) > 0.0F)) return false;
    }
  }
  return true;
}

float inner_radius(Polygon body, Vec2 center) {
  float least = kInfinity;
  for (int i = 0; i < body.count; ++i) {
    const float distance = distance_left(body[i], body[(i + 1) % body.count], center);
    if (distance < least) least = distance;
  }
  return std::max(0.0F, least);
}

Vec2 middle(Polygon body) {
  Vec2 sum{};
  for (int i = 0; i < body.count; ++i) sum = sum + body[i];
  return (1.0F / static_cast<float>(body.count)) * sum;
}

Argument first_bad_of_robot(const Robot& robot) {
  if (!robot.sound()) return Argument::robot_dimensions;
  if (!robot.sizes_valid()) return Argument::robot_sizes;
  for (int k = 0; k < robot.body_count(); ++k) {
    if (!usable_body(robot.body(k))) return Argument::robot_polygon;
  }
  return Argument::none;
}

float body_length(Polygon body) {
  float low = body[0].x;
  float high = body[0].x;
  for (int i = 1; i < body.count; ++i) {
    if (body[i].x < low) low = body[i].x;
    if (body[i].x > high) high = body[i].x;
  }
  return high - low;
}

float robot_length(const Robot& robot) { return body_length(robot.body(0)); }

}  // namespace krait::detail
