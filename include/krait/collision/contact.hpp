// SPDX-License-Identifier: Apache-2.0
// What a robot overlaps, or comes too near to, where it stands.
#pragma once

#include "krait/base/math.hpp"
#include "krait/scene/scene.hpp"

namespace krait {

enum class Hindrance : std::uint8_t {
  none,
  obstacle,  // a piece of the scene
  bounds,    // of the workspace
  body,      // another one of the robot's own
  ground     // the position lies in no triangle of the scene
};

// Metres, local coordinates.
struct Contact {
  Hindrance with = Hindrance::none;
  Index body = 0;         // of the robot
  Index other = kNone;    // the piece, or the other body
  float distance = 0.0F;  // between the two; 0 where they overlap
  float needed = 0.0F;    // that they must keep: the clearance, and what rounding needs
  Vec2 at{};              // the middle between their nearest points, or a point of both
};

}  // namespace krait
