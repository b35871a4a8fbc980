// SPDX-License-Identifier: Apache-2.0
// Numbers of things, and points, frames, boxes and polygons in the plane; metres.
#pragma once

#include <cstdint>

#include "krait/math.hpp"

namespace krait {

// Numbers of triangles, regions, vertices and whatever else stands in an array.
using Index = std::uint32_t;
inline constexpr Index kNone = 0xFFFFFFFF;

struct Vec2 {
  float x;
  float y;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(float k, Vec2 a) { return {k * a.x, k * a.y}; }
inline float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
inline float cross(Vec2 a, Vec2 b) { return a.x * b.y - math::product(a.y, b.x); }
inline float length(Vec2 a) { return std::sqrt(dot(a, a)); }

inline bool finite(Vec2 a) { return finite(a.x) && finite(a.y); }

// The vector turned by the angle.
inline Vec2 turned(SinCos angle, Vec2 p) {
  return {angle.cos * p.x - math::product(angle.sin, p.y), angle.sin * p.x + math::product(angle.cos, p.y)};
}

// Sine and cosine of the sum and of the difference of two angles.
inline SinCos operator+(SinCos a, SinCos b) {
  return {a.sin * b.cos + math::product(a.cos, b.sin), a.cos * b.cos - math::product(a.sin, b.sin)};
}
inline SinCos operator-(SinCos a, SinCos b) {
  return {a.sin * b.cos - math::product(a.cos, b.sin), a.cos * b.cos + math::product(a.sin, b.sin)};
}

// A frame in the plane: where its origin lies, and the direction of its x axis.
struct Pose {
  Vec2 position;
  SinCos heading;
};

// Turns `count` frames to as many angles: math::sin_cos of each, bit for bit, several at a time where the processor
// can.
void turn_to(const float* angles, int count, Pose* frames);

// The angle between two directions, in [0, pi].
inline float angle_between(SinCos a, SinCos b) {
  const SinCos apart = a - b;
  return math::absolute(math::atan2(apart.sin, apart.cos));
}

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

// Writes the four corners, counter-clockwise, of a rectangle whose centre lies `offset` ahead of its frame's origin,
// its length along the x axis; metres.
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
