// SPDX-License-Identifier: Apache-2.0
/// \file
/// What both unicycles and the differential drive share: one box on an axle, state (x, y, theta, …).
#pragma once

#include "krait/geometry.hpp"
#include "krait/robots/detail/functions.hpp"

namespace krait {

/// One body on an axle. It owns its polygon. Every function of it is O(1).
class PlanarBody {
 public:
  static constexpr int kMaxBodies = 1;  ///< the body

  /// A box of that length and width in metres, centred on the axle.
  PlanarBody(float body_length, float body_width) {
    rectangle(body_length, body_width, 0.0F, vertices_);
    count_ = 4;
  }

  int body_count() const { return 1; }  ///< one
  /// In the axle's frame, metres; the vertices are this robot's.
  Polygon body(int) const { return {vertices_, count_}; }

  /// Replaces the polygon: metres, 3 to 8 vertices, convex, counter-clockwise, in the axle's frame; copied. Of a
  /// polygon with more vertices it keeps none of them, and init then refuses the robot as bad_robot.
  void set_body(int, Polygon polygon) {
    count_ = polygon.count <= kMaxVertices ? polygon.count : 0;
    for (int i = 0; i < count_; ++i) vertices_[i] = polygon[i];
  }

  /// Writes the body's frame: the axle's middle and the heading.
  void place(StateView s, Pose* poses) const { poses[0] = {position(s), math::sin_cos(s[2])}; }

 protected:
  /// Writes position and heading, and zeros behind them, to `size` floats: standing still.
  static void stand(Vec2 position, float heading, int size, float* state) {
    state[0] = position.x;
    state[1] = position.y;
    state[2] = heading;
    for (int i = 3; i < size; ++i) state[i] = 0.0F;
  }

  /// Heading error to the target in radians, of the rear when driving backwards.
  static float heading_error(StateView s, const Target& target) {
    const SinCos heading = math::sin_cos(s[2]);
    const Vec2 to{target.point.x - s[0], target.point.y - s[1]};
    const Vec2 along{heading.cos, heading.sin};
    return target.speed < 0.0F ? math::atan2(-cross(along, to), -dot(along, to))
                               : math::atan2(cross(along, to), dot(along, to));
  }

 private:
  Vec2 vertices_[kMaxVertices];
  int count_ = 0;
};

}  // namespace krait
