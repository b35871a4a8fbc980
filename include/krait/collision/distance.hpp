// SPDX-License-Identifier: Apache-2.0
// Exact distance of two convex polygons, by Box2D's GJK.
#pragma once

#include "krait/scene/scene.hpp"

namespace krait {

// Metres between the convex hulls of a and b (3 to 16 vertices each), 0 when they overlap or when GJK has no answer
// after its 20 rounds. Give both relative to a point near one of them: float GJK overestimates by about 2e-7 of the
// largest coordinate, which is the caller's to subtract.
float polygon_distance(Polygon a, Polygon b);

}  // namespace krait
