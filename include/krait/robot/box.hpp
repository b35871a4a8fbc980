// SPDX-License-Identifier: Apache-2.0
// The rectangle that most bodies are.
#pragma once

#include "krait/base/math.hpp"

namespace krait {

// Four corners, counter-clockwise, of a box whose centre lies `offset` ahead of the frame's origin; metres.
inline void box(float length, float width, float offset, Vec2* corners) {
  const float front = offset + 0.5F * length;
  const float back = offset - 0.5F * length;
  const float side = 0.5F * width;
  corners[0] = {back, -side};
  corners[1] = {front, -side};
  corners[2] = {front, side};
  corners[3] = {back, side};
}

// Largest distance of `count` points from the origin.
inline float farthest(const Vec2* points, int count) {
  float most = 0.0F;
  for (int i = 0; i < count; ++i) {
    const float distance = length(points[i]);
    if (distance > most) most = distance;
  }
  return most;
}

}  // namespace krait
