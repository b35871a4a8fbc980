// SPDX-License-Identifier: Apache-2.0
// How a route's vias are driven to: corners rounded by what the robot can turn, and the random changes that are tried.
#pragma once

#include "base/random.hpp"
#include "improve/route.hpp"

namespace krait::detail {

// What a robot's turns are like.
struct Turns {
  static constexpr std::uint32_t kShares = 6;
  // Values of Target::turn; measured: bench/ABLATIONS.md, "Constants".
  static constexpr float kShare[kShares] = {1.0F, 0.7F, 0.5F, 0.35F, 0.25F, 0.18F};

  float radius[kShares];  // metres: of a long turn at each
  float unit;             // metres: half the robot's length and what it drives in two time steps
  float trail = 0.0F;     // metres: of one trailer that cuts corners as its trailers do; 0: no corner is moved for them
};

// A standard normal number, nearly: six uniform ones.
float normal(Random& random);

// Looks ahead and turns at random on the way to the via.
void vary(Via& via, const Turns& turns, Random& random);

// Rounds the corner at `via` by one of the turns: sets how it is driven to, and moves it outward by a random share of
// what the turn's circle would cut off, and what trailers would.
void round_corner(Vec2 before, Via& via, Vec2 after, const Turns& turns, Random& random);

// Makes a random change at via i, 1 … count - 1, of an unmeasured copy of a route: rounds the corner again, drives to
// it otherwise, or moves it.
void change_via(Route& route, std::uint32_t i, const Turns& turns, Random& random);

// The same, or leaves the via out, or adds one before it.
void change(Route& route, std::uint32_t i, const Turns& turns, Random& random);

}  // namespace krait::detail
