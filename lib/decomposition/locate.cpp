// SPDX-License-Identifier: Apache-2.0
#include "decomposition/locate.hpp"

#include "scene/grid_point.hpp"

namespace krait::detail {
namespace {

// Steps of a walk from triangle to triangle. After them the bucket is searched, which finds the same triangle.
constexpr int kMaxWalk = 16;

// The first edge that has p strictly on its right, or -1 when p is inside or on the border. Stands in the program once.
[[gnu::noinline, gnu::flatten]] int edge_towards(const Scene& scene, Index triangle, GridPoint p) {
  const GridPoint corners[3] = {to_grid(scene.corner(triangle, 0)), to_grid(scene.corner(triangle, 1)),
                                to_grid(scene.corner(triangle, 2))};
  for (int i = 0; i < 3; ++i) {
    if (orientation(corners[i], corners[(i + 1) % 3], p) < 0) return i;
  }
  return -1;
}

Index walk(const Scene& scene, GridPoint p, Index triangle) {
  for (int step = 0; step < kMaxWalk && triangle != kNone; ++step) {
    const int edge = edge_towards(scene, triangle, p);
    if (edge < 0) return triangle;
    triangle = scene.neighbor(triangle, edge);
  }
  return kNone;
}

Index scan_bucket(const Scene& scene, Vec2 p, GridPoint grid_point) {
  const std::size_t bucket = scene.buckets().index(scene.buckets().cell(p));
  const std::uint32_t end = scene.bucket_triangles_begin(bucket + 1);
  for (std::uint32_t i = scene.bucket_triangles_begin(bucket); i < end; ++i) {
    const Index triangle = scene.bucket_triangle(i);
    if (edge_towards(scene, triangle, grid_point) < 0) return triangle;
  }
  return kNone;
}

}  // namespace

[[gnu::flatten]] Index locate(const Scene& scene, Vec2 p, Index hint) {
  if (!scene.inside_bounds(p)) return kNone;
  const GridPoint grid_point = to_grid(p);
  const Index near = walk(scene, grid_point, hint);
  if (near != kNone) return near;
  // The bucket of the rounded point: a triangle that meets it is in that bucket's list.
  const Vec2 rounded{static_cast<float>(grid_point.x) * format::kGrid,
                     static_cast<float>(grid_point.y) * format::kGrid};
  return scan_bucket(scene, rounded, grid_point);
}

}  // namespace krait::detail
