// SPDX-License-Identifier: Apache-2.0
/// \file
/// The goal of a query: a named polygon of the scene, any disc, or a disc with a heading to end with.
#pragma once

#include "krait/scene.hpp"

namespace krait {

/// The headings of the bodies with which a plan must end.
struct Facing {
  float heading = 0.0F;       ///< radians, of body 0, at most kMaxAngle either way
  float tolerance = 0.1F;     ///< radians, above 0 and at most pi: how far off the heading may be; pi: it is free
  bool either_way = false;    ///< whether the opposite heading is accepted as well
  float hitches = kInfinity;  ///< radians, above 0: how far the heading of every other body may differ from that of
                              ///< the body before it; infinite: hitch angles are free
};

/// Where a plan ends. A value, which refers to nothing. It may hold any numbers: valid() returns whether they can be
/// used, and the functions after it, to which the same scene is passed, require that they can. Every function is O(1)
/// where nothing else is stated.
class Goal {
 public:
  /// The scene's goal of that number, 0 … Scene::goal_count() - 1.
  static Goal named(Index goal);
  /// The disc around a point of the scene's bounds, metres, local coordinates; radius > 0, metres.
  static Goal disc(Vec2 center, float radius) { return {kNone, center, radius}; }
  /// The position within `radius` metres of a point, and the bodies turned as `facing` says.
  static Goal pose(Vec2 point, float radius, const Facing& facing) {
    Goal goal = disc(point, radius);
    goal.is_pose_ = true;
    goal.facing_ = facing;
    return goal;
  }
  /// The same, of body 0's heading alone: within `tolerance` radians, above 0 and at most pi, of `heading`, radians, at
  /// most kMaxAngle either way.
  static Goal pose(Vec2 point, float radius, float heading, float tolerance) {
    return pose(point, radius, Facing{heading, tolerance});
  }

  /// Whether it lies around a point: a disc's or a pose's.
  bool is_disc() const { return index_ == kNone; }
  /// Whether the bodies' headings matter. All functions below, except for valid(), look at the position only.
  bool is_pose() const { return is_pose_; }
  const Facing& facing() const { return facing_; }  ///< of a pose
  Index index() const { return index_; }            ///< of a named goal; kNone of a disc or a pose
  Vec2 center() const { return center_; }           ///< metres, local coordinates; of a disc or a pose
  float radius() const { return radius_; }          ///< metres; of a disc or a pose

  /// Usable with this scene: the index exists; the disc is finite, has a radius, and its centre lies in the bounds; the
  /// facing's numbers are in their ranges.
  [[nodiscard]] bool valid(const Scene& scene) const;

  /// Whether p, metres, local coordinates, lies inside and at least `depth` metres from the border; where that is below
  /// 0, inside or at most so far outside. O(vertices of the polygon).
  bool contains(const Scene& scene, Vec2 p, float depth) const;

  /// Whether a triangle belongs to the goal: by its label, or by meeting the disc.
  bool covers(const Scene& scene, Index triangle) const;

  /// False only when every point of the triangle is further than `reach` metres from the goal. `box` is the goal's
  /// box().
  bool may_reach(const Scene& scene, Index triangle, float reach, const Box& box) const;

  /// Whether p lies in the goal or at most `reach` metres away from it. O(vertices of the polygon).
  bool near(const Scene& scene, Vec2 p, float reach) const;

  /// The smallest box around the goal, local metres. O(vertices of the polygon).
  Box box(const Scene& scene) const;

  /// Square root of the area, metres: above 0, since Scene::open refuses a goal without area. O(vertices of the
  /// polygon).
  float size(const Scene& scene) const;

  /// Metres, above 0: how deep inside the goal a plan can be made to end: a tenth of size(), and less of a polygon that
  /// is long and narrow. Some point of the goal lies twice as deep. O(vertices of the polygon).
  float deepest(const Scene& scene) const;

 private:
  Goal(Index index, Vec2 center, float radius) : index_(index), center_(center), radius_(radius) {}

  Index index_;
  Vec2 center_;
  float radius_;
  bool is_pose_ = false;
  Facing facing_;
};

}  // namespace krait
