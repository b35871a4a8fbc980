// SPDX-License-Identifier: Apache-2.0
// How much work one call of advance(1) can be at most: a bound by formula from the scene's tables, the robot and the
// parameters, which no call exceeds (tests/host/run/work_test.cpp counts).
#pragma once

#include <cstdint>

#include "krait/krait.hpp"

namespace krait::host {

struct Work {
  std::uint64_t placements = 0;         // of the whole robot that are judged
  std::uint64_t runge_kutta_steps = 0;  // of the costlier: growing by an expansion, or driving one for the plan
  std::uint64_t polygon_distances = 0;  // of GJK, which takes at most 20 rounds
  std::uint64_t heap_operations = 0;    // pushes and pops of one Dijkstra
  std::uint64_t sketched_steps = 0;     // of the whole robot, in a coarse roll-out
  std::uint64_t discs = 0;              // that are looked at, each against every piece near it
  std::uint64_t pieces_near = 0;        // obstacle pieces that a body can be tested against in one placement
};

// What the bound needs to know of a robot.
struct RobotExtent {
  std::uint64_t bodies = 1;
  std::uint64_t gap = 2;        // bodies so far apart in the chain are tested against each other
  float largest_radius = 0.0F;  // metres, of the circle around a body's box
  float longest_travel = 0.0F;  // metres, of a body's point in a time step
  float length = 0.0F;          // metres, of body 0
  int tree_parts = 1;           // Runge-Kutta steps of a time step while the tree grows
  int plan_parts = 1;           // and while a plan is driven
};

Work work_bound(const krait::Scene& scene, const RobotExtent& robot, const Parameters& parameters);

}  // namespace krait::host
