// SPDX-License-Identifier: Apache-2.0
#include "search/disc_route.hpp"

#include "collision/obstacles.hpp"
#include "decomposition/locate.hpp"
#include "robot/shape.hpp"

namespace krait::detail {

float least_portal_width(const Robot& robot, float clearance) {
  const float inner = inner_radius(robot.body(0), {});
  return inner > 0.0F ? 2.0F * (inner + clearance) : 0.0F;
}

DiscRoute::DiscRoute(const Robot& robot, Regions& regions, const Goal& goal, float depth, float clearance, Vec2 start,
                     const Pose& body)
    : regions_(regions), scene_(regions.scene()), goal_(goal), depth_(depth) {
  const Polygon polygon = robot.body(0);
  const Vec2 center = middle(polygon);
  around_middle_ = {body.position + turned(body.heading, center), inner_radius(polygon, center) + clearance,
                    length(center) + kReachRounding};
  around_position_ = {start, inner_radius(polygon, {}) + clearance, 0.0F};
}

bool DiscRoute::fits() {
  if (!room_at_goal(around_position_).enough || !room_at_goal(around_middle_).enough) return false;
  const Index triangle = locate(scene_, around_middle_.at);
  return triangle == kNone || regions_.connected(triangle, goal_, around_middle_.reach, 2.0F * around_middle_.radius);
}

Bottleneck DiscRoute::narrowest(bool failed) {
  const Bottleneck bottleneck = narrowest(around_middle_);
  return failed && !(bottleneck.width < bottleneck.needed) ? narrowest(around_position_) : bottleneck;
}

GoalRoom DiscRoute::room_at_goal(const Disc& disc) const {
  const Obstacles obstacles(scene_, 0.0F);
  return goal_room(scene_, obstacles, goal_, disc.reach - depth_, disc.radius - 2.0F * obstacles.margin());
}

Bottleneck DiscRoute::narrowest(const Disc& disc) {
  const float needed = 2.0F * disc.radius;
  const GoalRoom room = room_at_goal(disc);
  if (!room.enough) return {2.0F * room.found, needed, room.at, true};
  const Index triangle = locate(scene_, disc.at);
  if (triangle == kNone) return {};
  Bottleneck bottleneck = regions_.widest_way(triangle, disc.reach);
  bottleneck.needed = needed;
  return bottleneck;
}

}  // namespace krait::detail
