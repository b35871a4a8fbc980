// SPDX-License-Identifier: Apache-2.0
// What follows from a robot's numbers: how it turns, how much room it sweeps then, how it stops, how it is integrated.
#pragma once

#include <string>
#include <vector>

#include "host/robot_file/robot_file.hpp"
#include "krait/parameters.hpp"

namespace krait::host {

// A turn without end in which no hitch angle changes any more: the whole robot rotates around one point.
struct SteadyTurn {
  double radius = 0;                 // metres, of the middle of body 0's axle; 0 on the spot
  std::vector<double> hitch_angles;  // radians, each body's behind the one ahead, positive in a turn to the left
  double inner = 0;                  // metres, the nearest point of any body to the centre of the turn; 0: it is inside
  double outer = 0;                  // metres, the farthest point
  double swept_width = 0;            // metres, of the ring between them; of a turn on the spot, of the disc
};

struct RobotFacts {
  double lock_radius = 0;  // metres, of the middle of body 0's axle at full lock or least speed; 0 on the spot
  double lock_outer = 0;   // metres, how far the farthest point of body 0 is from the centre of that turn
  bool folds_at_lock =
      false;               // at full lock the trailers do not follow: no turn is steady, or a hitch passes its limit
  SteadyTurn tightest;     // of all steady turns; where the trailers fold at full lock, 10 % wider than the limit
  double top_speed = 0;    // metres a second, forward
  double least_speed = 0;  // metres a second, of a robot that never stands still; 0 of any other
  bool stops_at_once = false;    // its speed is its control
  double stopping_time = 0;      // seconds, from top speed
  double stopping_distance = 0;  // metres
  double fastest_rate = 0;       // 1/s, of the core's robot
  double longest_time_step = 0;  // seconds, that init takes; 0: none
  int tree_parts = 1;            // Runge-Kutta steps of a time step while the tree grows
  int plan_parts = 1;            // and while a plan is driven
  double step_error = 0;         // metres, that a body is off after a second at top speed and full lock in those steps
};

// Throws InputError, naming `name`, for a robot that the core refuses whatever the time step.
void require_usable(const std::string& name, const RobotSpec& robot);

// What is said of a robot whose longest_time_step is 0.
inline constexpr const char* kNoTimeStep = "none of 0.001 s or more: the robot changes too fast to be planned for";

// That the steered axle lies outside of body 0, by how much, and what may be wrong: one line; empty where it lies
// inside.
std::string axle_warning(const RobotSpec& robot);

// Metres a second, of a robot that never stands still; 0 of any other.
double least_speed(const RobotSpec& robot);

// Metres, of the circle of the middle of body 0's axle at full lock, or at the least speed; 0 for a robot that turns on
// the spot.
double lock_radius(const RobotSpec& robot);

// The bodies in the turn, to the left around (0, radius), body 0 at the origin with heading 0.
std::vector<Ring> bodies_in(const SteadyTurn& turn, const RobotSpec& robot);

// The facts at the parameters' time step. Throws as require_usable.
RobotFacts facts_of(const std::string& name, const RobotSpec& robot, const Parameters& parameters);

}  // namespace krait::host
