// SPDX-License-Identifier: Apache-2.0
// The goal of a query: a named polygon of the scene, or any disc.
#pragma once

#include "krait/base/random.hpp"
#include "krait/scene/scene.hpp"

namespace krait {

class Goal {
 public:
  static Goal named(Index goal) { return {goal, {}, 0.0F}; }
  // Centre in local coordinates, radius > 0, metres.
  static Goal disc(Vec2 center, float radius) { return {kNone, center, radius}; }

  bool is_disc() const { return index_ == kNone; }
  Index index() const { return index_; }
  Vec2 center() const { return center_; }
  float radius() const { return radius_; }

  // Usable with this scene: the index exists; the disc is finite, has a radius, and its centre lies in the bounds.
  bool valid(const Scene& scene) const;

  // Whether p lies inside and at least `depth` metres from the border. O(vertices of the polygon).
  bool contains(const Scene& scene, Vec2 p, float depth) const;

  // Whether a triangle belongs to the goal: by its label, or by meeting the disc.
  bool covers(const Scene& scene, Index triangle) const;

  // False only when every point of the triangle is further than `reach` metres from the goal. O(vertices of the
  // polygon).
  bool may_reach(const Scene& scene, Index triangle, float reach) const;

  // Whether p lies in the goal or at most `reach` metres away from it. O(vertices of the polygon).
  bool near(const Scene& scene, Vec2 p, float reach) const;

  // The smallest box around the goal. O(vertices of the polygon).
  Box box(const Scene& scene) const;

  // Square root of the area, metres: above 0, since Scene::open refuses a goal without area. O(vertices of the
  // polygon).
  float size(const Scene& scene) const;

 private:
  Goal(Index index, Vec2 center, float radius) : index_(index), center_(center), radius_(radius) {}

  Index index_;
  Vec2 center_;
  float radius_;
};

}  // namespace krait
