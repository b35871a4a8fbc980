// SPDX-License-Identifier: Apache-2.0
#include "host/import/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/workspace/heading.hpp"

namespace krait::host {
namespace {

constexpr double kError = 0.01;     // m between polygon and circle, where 128 corners suffice for it
constexpr double kRounding = 1e-9;  // relative; keeps "contains" and "inside" true after rounding

// Half the angle that an edge spans.
double half_edge_angle(double radius) {
  const double wanted = std::acos(radius / (radius + kError));
  return std::numbers::pi / std::clamp(std::ceil(std::numbers::pi / wanted), 8.0, 128.0);
}

Ring regular(const Point& center, double corner_radius, double half_angle) {
  const auto corners = static_cast<std::size_t>(std::lround(std::numbers::pi / half_angle));
  Ring ring(corners);
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = static_cast<double>(2 * i + 1) * half_angle;
    ring[i] = {center.x + corner_radius * std::cos(angle), center.y + corner_radius * std::sin(angle)};
  }
  return ring;
}

Ring box_ring(const Point& center, double width, double height, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Ring ring = {{-width / 2, -height / 2}, {width / 2, -height / 2}, {width / 2, height / 2}, {-width / 2, height / 2}};
  for (Point& corner : ring) {
    corner = {center.x + c * corner.x - s * corner.y, center.y + s * corner.x + c * corner.y};
  }
  return ring;
}

double read_angle(const Field& field) {
  const double angle = field.number(-kMaxAngle, kMaxAngle, "radians");
  if (is_over_a_turn(angle)) field.fail("an angle of " + angle_over_a_turn(angle));
  return angle;
}

}  // namespace

Ring read_box(const Field& box, std::initializer_list<const char*> angle_names) {
  const Field size = box.at("size");
  if (size.size() != 2) size.fail("must be [width, height]");
  const auto* const name = std::find_if(angle_names.begin(), angle_names.end(), [&](auto key) { return box.has(key); });
  const double angle = name == angle_names.end() ? 0 : read_angle(box.at(*name));
  return box_ring(box.at("center").point(kMaxFarCoordinate), size.item(0).number(kMinLength, kMaxCoordinate, "metres"),
                  size.item(1).number(kMinLength, kMaxCoordinate, "metres"), angle);
}

Ring ring_around_circle(const Point& center, double radius) {
  const double half_angle = half_edge_angle(radius);
  return regular(center, radius / std::cos(half_angle) * (1 + kRounding), half_angle);
}

Ring ring_inside_circle(const Point& center, double radius) {
  return regular(center, radius * (1 - kRounding), half_edge_angle(radius));
}

Goal pose_goal(const std::string& name, const GoalPose& pose) {
  return {name, ring_inside_circle(pose.position, pose.radius), pose};
}

}  // namespace krait::host
