// SPDX-License-Identifier: Apache-2.0
// Boxes and polygons in the plane, metres.
#pragma once

#include "krait/base/math.hpp"

namespace krait {

struct Box {
  Vec2 min;
  Vec2 max;
};

inline constexpr int kMinVertices = 3;  // of a convex obstacle piece or a body
inline constexpr int kMaxVertices = 8;

// `count` vertices, counter-clockwise, convex where it stands for an obstacle piece or a body.
struct Polygon {
  const Vec2* vertices = nullptr;
  int count = 0;

  Vec2 operator[](int i) const { return vertices[i]; }
};

// The smallest box around a polygon's vertices.
inline Box bounding_box(Polygon polygon) {
  Box box{polygon[0], polygon[0]};
  for (int i = 1; i < polygon.count; ++i) {
    const Vec2 p = polygon[i];
    box.min = {p.x < box.min.x ? p.x : box.min.x, p.y < box.min.y ? p.y : box.min.y};
    box.max = {p.x > box.max.x ? p.x : box.max.x, p.y > box.max.y ? p.y : box.max.y};
  }
  return box;
}

}  // namespace krait
