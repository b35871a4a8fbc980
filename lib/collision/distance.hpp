// SPDX-License-Identifier: Apache-2.0
// Exact distance of two convex polygons, by Box2D's GJK.
#pragma once

#include "krait/scene.hpp"

namespace krait::detail {

// Metres between the convex hulls of a and b (1 to 16 vertices each), 0 when they overlap or when GJK has no answer
// after its 20 rounds. Pass both relative to a point near one of them: float GJK overestimates by about 2e-7 of the
// largest coordinate, which is the caller's to subtract.
float polygon_distance(Polygon a, Polygon b);

// The same distance, and the middle between the two nearest points: a point of both hulls where they overlap.
struct Gap {
  float distance;
  Vec2 middle;
};
Gap polygon_gap(Polygon a, Polygon b);

}  // namespace krait::detail
