// SPDX-License-Identifier: Apache-2.0
// An aisle with a row of obstacles on its left in which a parking space is free, and cars that reverse.
#pragma once

#include "planner_fixture.hpp"

namespace krait::test::parking {

inline constexpr float kLength = 1.2F;  // of the car, whose axle is 0.4 m from its middle
inline constexpr float kAxle = 0.4F;
inline constexpr float kSpace = 6.0F;  // where the middle of the space is along the aisle

inline ChainParameters reversing() {
  ChainParameters parameters = Car::defaults();
  parameters.min_speed = -1;
  parameters.max_steering = 0.6F;
  parameters.max_steering_rate = 0.5F;
  return parameters;
}

// An aisle of 1.7 m with a row on its left, in which a space of so many lengths is free.
inline Room aisle(double lengths) {
  const double half = lengths * static_cast<double>(kLength) / 2;
  Room room;
  room.bounds = {0, 0, 12, 2.5};
  room.boxes = {{1, 1.75, 6 - half, 2.5}, {6 + half, 1.75, 11, 2.5}};
  room.goals = {{5.5, 1.9, 6.5, 2.4}};
  return room;
}

inline Goal space() { return Goal::pose({kSpace - kAxle, 2.11F}, 0.05F, {0.0F, 0.1F, false, kInfinity}); }

// One whose speed and steering angle change at once.
inline KinematicTruckParameters kinematic() {
  KinematicTruckParameters parameters;
  parameters.body_length = kLength;
  parameters.body_width = 0.6F;
  parameters.body_offset = kAxle;
  parameters.min_speed = -1;
  parameters.max_steering = 0.6F;
  return parameters;
}

}  // namespace krait::test::parking
