// SPDX-License-Identifier: Apache-2.0
// Where the ways to a goal are narrow.
#pragma once

#include "krait/base/math.hpp"

namespace krait {

// The widest of all ways from the start to the goal, at its narrowest place. Metres, local coordinates.
struct Bottleneck {
  float width = 0.0F;    // of a disc that passes there; 0 where no way leads to the goal at all
  float needed = 0.0F;   // of the disc that lies in body 0, with the clearance on both sides
  Vec2 at{};             // the place, where there is a way
  bool at_goal = false;  // whether the place is the roomiest of the goal itself: the robot cannot stand in it
};

}  // namespace krait
