// SPDX-License-Identifier: Apache-2.0
#include "collision/distance.hpp"

// Box2D lives in a namespace of our own, so that a program may link another Box2D beside it. Everything that its
// headers include comes first, outside.
#include <assert.h>
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

namespace krait::box2d {
#include "b2_distance_source.h"
const b2Vec2 b2Vec2_zero(0.0F, 0.0F);  // the one definition that the distance needs from b2_math.cpp
}  // namespace krait::box2d

namespace krait::detail {
namespace {

box2d::b2DistanceOutput measure(Polygon a, Polygon b) {
  static_assert(sizeof(Vec2) == sizeof(box2d::b2Vec2) && alignof(Vec2) == alignof(box2d::b2Vec2));
  box2d::b2DistanceInput input;
  input.proxyA.Set(reinterpret_cast<const box2d::b2Vec2*>(a.vertices), a.count, 0.0F);
  input.proxyB.Set(reinterpret_cast<const box2d::b2Vec2*>(b.vertices), b.count, 0.0F);
  input.transformA.SetIdentity();
  input.transformB.SetIdentity();
  input.useRadii = false;
  box2d::b2SimplexCache cache;
  cache.count = 0;
  box2d::b2DistanceOutput output;
  box2d::b2Distance(&output, &cache, &input);
  constexpr int kMaxRounds = 20;  // b2Distance returns after this many iterations
  if (output.iterations >= kMaxRounds) output.distance = 0.0F;
  return output;
}

}  // namespace

float polygon_distance(Polygon a, Polygon b) { return measure(a, b).distance; }

Gap polygon_gap(Polygon a, Polygon b) {
  const box2d::b2DistanceOutput output = measure(a, b);
  const Vec2 on_a{output.pointA.x, output.pointA.y};
  const Vec2 on_b{output.pointB.x, output.pointB.y};
  return {output.distance, 0.5F * (on_a + on_b)};
}

}  // namespace krait::detail
