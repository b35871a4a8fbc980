// SPDX-License-Identifier: Apache-2.0
// Where a disc that lies in the robot's first body finds no way to the goal, the robot finds none.
#pragma once

#include "collision/goal_room.hpp"
#include "decomposition/regions.hpp"
#include "krait/robot.hpp"

namespace krait::detail {

// Metres, for Regions::reset: no obstacle comes nearer to the position than the disc around it that lies in body 0, if
// there is one; 0 else. The disc is `clearance` metres larger.
float least_portal_width(const Robot& robot, float clearance);

class DiscRoute {
 public:
  // Robot, scene and regions must outlive this. `body` is the pose of body 0 at the start, `start` the robot's
  // position, `depth` metres: how deep inside the goal the position must be in the end.
  DiscRoute(const Robot& robot, Regions& regions, const Goal& goal, float depth, float clearance, Vec2 start,
            const Pose& body);

  // False when a disc finds no room in the goal, or no way from the start to so near the goal that the position could
  // be inside. Uses the regions' tables as scratch. Work: O(R), and at most 2,730 distances of a point.
  bool fits();

  // The narrowest place of the widest way, of the larger disc or, if `failed`, of that which does not fit. Work: a
  // Dijkstra for the widest way and one for the costs, each at most twice, and at most 2,730 distances of a point.
  Bottleneck narrowest(bool failed);

 private:
  // Metres: far more than rounding takes from places at most 2 km from the origin, some 1e-4.
  static constexpr float kReachRounding = 1e-2F;

  // It goes where the body goes.
  struct Disc {
    Vec2 at;       // its centre at the start
    float radius;  // metres, the clearance included
    float reach;   // metres: how far the centre may be from the goal while the position is inside
  };

  // The room that the points have at which the disc's centre may be in the end.
  GoalRoom room_at_goal(const Disc& disc) const;

  Bottleneck narrowest(const Disc& disc);

  Regions& regions_;
  const Scene& scene_;
  Goal goal_;
  float depth_;
  Disc around_middle_;    // of body 0
  Disc around_position_;  // smaller, but where the position is
};

}  // namespace krait::detail
