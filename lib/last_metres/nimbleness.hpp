// SPDX-License-Identifier: Apache-2.0
// What lines to a pose must be like for a robot, and how fast it drives them.
#pragma once

#include "krait/robot.hpp"

namespace krait::detail {

struct Nimbleness {
  float length;            // metres, of body 0
  float train;             // metres: the length times the number of bodies
  float turning_radius;    // metres; 0: turns on the spot
  float top_speed;         // m/s
  float half_width;        // metres: the radius of a disc around the position that lies in body 0
  float reach;             // metres: that of one which body 0 lies in
  bool backward;           // whether it may drive a line backwards,
  int backing_body;        // and the body that keeps to the line then
  float dt;                // seconds
  float clearance;         // metres, that it keeps to obstacles
  Polygon outline;         // of body 0, whose vertices are the robot's
  const Parking* parking;  // how it drives into narrow places in reverse; null: it does not
  const Docking* docking;  // how it pushes trailers to a pose; null: it does not
};

// A robot in a state, and the frames of its bodies. All of it is the caller's.
struct Moment {
  const Robot& robot;
  const float* state;
  const Pose* poses;
  const Pose& at() const { return poses[0]; }
};

inline constexpr float kSlowest = 0.02F;  // of the top speed; measured: bench/ABLATIONS.md, "Constants"

// The share of its top speed at which a robot moves on that shall come to rest `remaining` metres ahead, moves at
// `speed` m/s and would come to rest within `stopping_way` metres if it braked as sharply as it can: it brakes
// `braking` times as sharply, and approaches the end of the way within some time steps, whatever its brake, at
// `slowest` of its top speed at least.
float pace(const Nimbleness& robot, float remaining, float speed, float stopping_way, float braking,
           float slowest = kSlowest);

}  // namespace krait::detail
