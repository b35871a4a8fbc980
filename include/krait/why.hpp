// SPDX-License-Identifier: Apache-2.0
/// \file
/// Why a search has found no plan: what the robot overlaps, where the ways are narrow, where it tried most.
#pragma once

#include <cstdint>

#include "krait/geometry.hpp"

namespace krait {

/// What a robot is too near to.
enum class Hindrance : std::uint8_t {
  none,      ///< nothing
  obstacle,  ///< a piece of the scene
  bounds,    ///< of the workspace
  body,      ///< another one of the robot's own
  ground     ///< the position lies in no triangle of the scene
};

/// What a body is too near to, and where. Metres, local coordinates.
struct Contact {
  Hindrance with = Hindrance::none;  ///< what it is; what follows is zero where it is nothing
  Index body = 0;                    ///< of the robot, 0 … body_count - 1
  Index other = kNone;               ///< the piece, or the other body; else kNone
  float distance = 0.0F;             ///< metres between the two; 0 where they overlap
  float needed = 0.0F;               ///< metres that they must keep: the clearance, and what rounding needs
  Vec2 at{};                         ///< the middle between their nearest points, or a point of both
};

/// The widest of all ways from the start to the goal, at its narrowest place. Metres, local coordinates.
struct Bottleneck {
  float width = 0.0F;    ///< metres, of a disc that passes there; 0 where no way leads to the goal at all
  float needed = 0.0F;   ///< metres, of the disc that lies in body 0, with the clearance on both sides
  Vec2 at{};             ///< the place, where there is a way
  bool at_goal = false;  ///< whether the place is the roomiest of the goal itself: the robot cannot stand in it
};

/// The place where a search has tried most, as a rule in vain.
struct Effort {
  Vec2 at{};                ///< the middle of a region, local coordinates
  std::uint32_t tries = 0;  ///< expansions from there since the search last began anew; 0: none
};

}  // namespace krait
