// SPDX-License-Identifier: Apache-2.0
#include "krait/goal.hpp"

#include <algorithm>

#include "scene/grid_point.hpp"

namespace krait {

using detail::GridPoint;
using detail::to_grid;

namespace {

constexpr float kDeepestShare = 0.1F;  // of a goal's size: lib/DESIGN.md, "The goal is shrunk"

float distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const Vec2 ap = p - a;
  const float along = math::clamp(dot(ap, ab) / dot(ab, ab), 0.0F, 1.0F);
  return length(ap - along * ab);
}

bool crosses_ray(Vec2 p, Vec2 a, Vec2 b) {
  if ((a.y > p.y) == (b.y > p.y)) return false;
  const float side = cross(b - a, p - a);
  return b.y > a.y ? side > 0.0F : side < 0.0F;
}

bool inside(Polygon polygon, Vec2 p) {
  bool odd = false;
  Vec2 before = polygon[polygon.count - 1];
  for (int i = 0; i < polygon.count; ++i) {
    if (crosses_ray(p, before, polygon[i])) odd = !odd;
    before = polygon[i];
  }
  return odd;
}

float distance_to_border(Polygon polygon, Vec2 p) {
  float least = kInfinity;
  for (int i = 0; i < polygon.count; ++i) {
    const float distance = distance_to_segment(p, polygon[i], polygon[(i + 1) % polygon.count]);
    if (distance < least) least = distance;
  }
  return least;
}

// NaN is in no range.
bool usable(const Facing& facing) {
  const bool turns = facing.tolerance > 0.0F && facing.tolerance <= kPi && math::absolute(facing.heading) <= kMaxAngle;
  return turns && facing.hitches > 0.0F;
}

bool triangle_meets_disc(const Scene& scene, Index triangle, Vec2 center, float radius) {
  bool inside = true;
  for (int i = 0; i < 3; ++i) {
    const Vec2 a = scene.corner(triangle, i);
    const Vec2 b = scene.corner(triangle, (i + 1) % 3);
    if (distance_to_segment(center, a, b) <= radius) return true;
    inside = inside && cross(b - a, center - a) >= 0.0F;
  }
  return inside;
}

}  // namespace

Goal Goal::named(Index goal) { return {goal, {}, 0.0F}; }

bool Goal::valid(const Scene& scene) const {
  if (is_pose() && !usable(facing_)) return false;
  if (!is_disc()) return index_ < scene.goal_count();
  return finite(center_) && finite(radius_) && radius_ > 0.0F && scene.inside_bounds(center_);
}

bool Goal::contains(const Scene& scene, Vec2 p, float depth) const {
  KRAIT_ASSERT(valid(scene));
  if (is_disc()) return length(p - center_) <= radius_ - depth;
  const Polygon polygon = scene.goal_polygon(index_);
  const bool in = inside(polygon, p);
  if (!in && depth >= 0.0F) return false;
  const float distance = distance_to_border(polygon, p);
  return in ? !(distance < depth) : distance <= -depth;
}

bool Goal::covers(const Scene& scene, Index triangle) const {
  KRAIT_ASSERT(valid(scene));
  return is_disc() ? triangle_meets_disc(scene, triangle, center_, radius_) : scene.goal_of(triangle) == index_;
}

bool Goal::may_reach(const Scene& scene, Index triangle, float reach, const Box& box) const {
  KRAIT_ASSERT(valid(scene));
  if (is_disc()) return triangle_meets_disc(scene, triangle, center_, radius_ + reach);
  const Vec2 corners[3] = {scene.corner(triangle, 0), scene.corner(triangle, 1), scene.corner(triangle, 2)};
  const Box a = bounding_box({corners, 3});
  return a.min.x - reach <= box.max.x && box.min.x - reach <= a.max.x && a.min.y - reach <= box.max.y &&
         box.min.y - reach <= a.max.y;
}

bool Goal::near(const Scene& scene, Vec2 p, float reach) const { return contains(scene, p, -reach); }

Box Goal::box(const Scene& scene) const {
  KRAIT_ASSERT(valid(scene));
  if (is_disc()) return {center_ - Vec2{radius_, radius_}, center_ + Vec2{radius_, radius_}};
  return bounding_box(scene.goal_polygon(index_));
}

float Goal::size(const Scene& scene) const {
  KRAIT_ASSERT(valid(scene));
  if (is_disc()) return 1.7724539F * radius_;  // sqrt(pi) * radius
  const Polygon polygon = scene.goal_polygon(index_);
  // The area is found in grid steps: floats would find none in a sliver, or a negative one. The sum wraps around and
  // ends exact.
  const GridPoint origin = to_grid(polygon[0]);
  std::uint64_t twice_area = 0;
  for (int i = 1; i + 1 < polygon.count; ++i) {
    twice_area += static_cast<std::uint64_t>(orientation(origin, to_grid(polygon[i]), to_grid(polygon[i + 1])));
  }
  return format::kGrid * std::sqrt(0.5F * static_cast<float>(static_cast<std::int64_t>(twice_area)));
}

float Goal::deepest(const Scene& scene) const {
  const float side = size(scene);
  const float most = kDeepestShare * side;
  if (is_disc()) return most;
  // The largest circle in any polygon has a radius of its area by its perimeter at least (Bonnesen).
  const Polygon polygon = scene.goal_polygon(index_);
  float perimeter = 0.0F;
  Vec2 last = polygon[polygon.count - 1];
  for (int i = 0; i < polygon.count; ++i) {
    perimeter += length(polygon[i] - last);
    last = polygon[i];
  }
  const float half_radius = 0.5F * side * side / perimeter;
  return std::min(most, half_radius);
}

}  // namespace krait
