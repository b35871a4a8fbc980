// SPDX-License-Identifier: Apache-2.0
/// \file
/// Indices, and points, frames, boxes and polygons in the plane; metres. And the hook for checked preconditions. Every
/// function is O(1) where nothing else is stated.
#pragma once

#include <cstdint>

#include "krait/math.hpp"

#ifdef KRAIT_ASSERT_HEADER
#include KRAIT_ASSERT_HEADER
#endif

#ifndef KRAIT_ASSERT
/// A precondition, such as that an index is below a count. It is checked where the build names a header,
/// KRAIT_ASSERT_HEADER, that defines the macro as an expression of type void; otherwise the condition is not evaluated,
/// and costs nothing.
#define KRAIT_ASSERT(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#endif

namespace krait {

/// The number of a triangle, a region, a vertex or whatever else stands in an array.
using Index = std::uint32_t;
inline constexpr Index kNone = 0xFFFFFFFF;  ///< the number of nothing

/// A point or a vector in the plane. Metres; points of the library are in the scene's local coordinates.
struct Vec2 {
  float x;  ///< metres
  float y;  ///< metres
};

/// The sum of two vectors.
inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
/// The vector from b to a.
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
/// The vector, k times as long.
inline Vec2 operator*(float k, Vec2 a) { return {k * a.x, k * a.y}; }
/// The scalar product; square metres.
inline float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Square metres: the area of the parallelogram of a and b, above 0 where b lies to the left of a.
inline float cross(Vec2 a, Vec2 b) { return a.x * b.y - math::product(a.y, b.x); }
/// The length of a vector; metres.
inline float length(Vec2 a) { return std::sqrt(dot(a, a)); }

/// Whether both coordinates are numbers: neither NaN nor infinite.
inline bool finite(Vec2 a) { return finite(a.x) && finite(a.y); }

/// The vector turned by the angle.
inline Vec2 turned(SinCos angle, Vec2 p) {
  return {angle.cos * p.x - math::product(angle.sin, p.y), angle.sin * p.x + math::product(angle.cos, p.y)};
}

/// Sine and cosine of the sum of two angles.
inline SinCos operator+(SinCos a, SinCos b) {
  return {a.sin * b.cos + math::product(a.cos, b.sin), a.cos * b.cos - math::product(a.sin, b.sin)};
}
/// Sine and cosine of the difference of two angles.
inline SinCos operator-(SinCos a, SinCos b) {
  return {a.sin * b.cos - math::product(a.cos, b.sin), a.cos * b.cos + math::product(a.sin, b.sin)};
}

/// A frame in the plane: where its origin lies, and the direction of its x axis.
struct Pose {
  Vec2 position;   ///< of the origin, metres
  SinCos heading;  ///< of the x axis
};

/// Turns `count` frames to as many angles in radians: math::sin_cos of each, bit for bit, several at a time where the
/// processor can. Their positions stay. Both arrays are the caller's. O(count).
void turn_to(const float* angles, int count, Pose* frames);

/// Radians: the angle between two directions, in [0, pi].
inline float angle_between(SinCos a, SinCos b) {
  const SinCos apart = a - b;
  return math::absolute(math::atan2(apart.sin, apart.cos));
}

/// A rectangle along the axes. Metres.
struct Box {
  Vec2 min;  ///< metres: the corner with the least x and y
  Vec2 max;  ///< metres: the corner with the largest x and y
};

inline constexpr int kMinVertices = 3;  ///< the least of a convex obstacle piece or a body
inline constexpr int kMaxVertices = 8;  ///< the most of a convex obstacle piece or a body

/// `count` vertices, counter-clockwise, convex where it stands for an obstacle piece or a body. It refers to them and
/// does not own them: the function that returns it says how long they stay.
struct Polygon {
  const Vec2* vertices = nullptr;  ///< metres
  int count = 0;                   ///< kMinVertices … kMaxVertices for a piece or a body, more for a goal

  /// Vertex i, 0 … count - 1.
  Vec2 operator[](int i) const {
    KRAIT_ASSERT(i >= 0 && i < count);
    return vertices[i];
  }
};

/// The smallest box around a polygon's vertices, of which there must be one. O(vertices).
inline Box bounding_box(Polygon polygon) {
  Box box{polygon[0], polygon[0]};
  for (int i = 1; i < polygon.count; ++i) {
    const Vec2 p = polygon[i];
    box.min = {p.x < box.min.x ? p.x : box.min.x, p.y < box.min.y ? p.y : box.min.y};
    box.max = {p.x > box.max.x ? p.x : box.max.x, p.y > box.max.y ? p.y : box.max.y};
  }
  return box;
}

/// Writes the four corners, counter-clockwise, of a rectangle whose centre lies `offset` ahead of its frame's origin,
/// its length along the x axis; metres. `corners` is the caller's, with room for four.
inline void rectangle(float length, float width, float offset, Vec2* corners) {
  const float front = offset + 0.5F * length;
  const float back = offset - 0.5F * length;
  const float side = 0.5F * width;
  corners[0] = {back, -side};
  corners[1] = {front, -side};
  corners[2] = {front, side};
  corners[3] = {back, side};
}

}  // namespace krait
