// SPDX-License-Identifier: Apache-2.0
// How a truck is steered that pushes its trailers: the last one is led to a point, or along the way that it took
// before. What is off in a hitch grows by e every hitch length that a trailer is pushed, so that the wheels must answer
// to all hitches at once.
#pragma once

#include "krait/geometry.hpp"

namespace krait::detail {

inline constexpr int kMostPushed = 3;  // trailers; measured: lib/robot/TRUCK.md, "Reverse"

// The trailers that a truck can push: all of them, or none. P: ChainParameters or the like.
template <class P>
int pushed(const P& p) {
  return p.min_speed < 0.0F && p.trailers <= kMostPushed ? p.trailers : 0;
}

// A car whose trailers roll without slip, each hitched over the axle before.
struct Train {
  int trailers;         // 1 … kMostPushed
  float wheelbase;      // metres
  float hitch_length;   // metres, axle to axle
  float most_steering;  // radians
  float most_hitch;     // radians
};

// P: ChainParameters or the like.
template <class P>
Train train_of(const P& p) {
  return {p.trailers, p.wheelbase, p.hitch_length, p.max_steering, p.max_hitch_angle};
}

// m/s: what a truck that is steered every dt seconds pushes its trailers with, at most. In a step of more of a hitch
// length no answer of the wheels comes in time.
inline float fastest_push(const Train& train, float dt) {
  return train.hitch_length / (static_cast<float>(1 + train.trailers) * dt);
}

// What the wheels do in a time step.
struct Wheels {
  float tangent;  // of their angle when it begins
  float lag;      // metres that the car goes until they are turned to another, about
  float way;      // metres that it goes in the step
  float swing;    // 1/m: the most that the tangent can change while it goes a metre; or infinity
};

// The tangent of the steering angle that leads the last trailer to `point`, going backwards. `poses` are the frames of
// all bodies. Any float: the caller keeps it within the lock. O(trailers).
float pushing_tangent(const Train& train, const Pose* poses, const Wheels& wheels, Vec2 point);

// What is to be added to the tangent of a reference, so that trailers which are very near to its trailers come back to
// them; wheels.tangent is the difference of both. Both arrays are the frames of all bodies. O(trailers).
float pushing_correction(const Train& train, const Pose* poses, const Pose* reference, const Wheels& wheels);

}  // namespace krait::detail
