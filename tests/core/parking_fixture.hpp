// SPDX-License-Identifier: Apache-2.0
// An aisle with a row of obstacles on its left in which a parking space is free, a bay, and cars that reverse.
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

// The same car as `reversing`, in a program without what parks.
struct Unparked : Car {
  Unparked() : Car(reversing()) {}
};

// A bay that a car stands in with its nose ahead: it must back out before it can drive along the aisle. No line from
// the start leads there, but for one that is driven backwards all the way, which is slow.
struct InABay : Bench<Car> {
  static constexpr float kNoseIn[] = {2.0F, 2.4F, 0.5F * kPi, 0, 0};

  explicit InABay(std::uint32_t way_legs) : Bench(bay(), Car(quickly_steered())) { limits.way_legs = way_legs; }

  static Room bay() {
    Room room;
    room.bounds = {0, 0, 24, 4};
    room.boxes = {{0, 2, 1.5, 4}, {2.5, 2, 24, 4}};
    room.goals = {{22, 0.2, 23.5, 1.8}};
    return room;
  }
  static ChainParameters quickly_steered() {
    ChainParameters parameters = reversing();
    parameters.max_steering_rate = 4;
    return parameters;
  }
};

}  // namespace krait::test::parking

template <>
inline constexpr bool krait::kParks<krait::test::parking::Unparked> = false;
