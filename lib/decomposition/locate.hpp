// SPDX-License-Identifier: Apache-2.0
// LOCATEREGION (section 4.1): the triangle that contains a point, by a walk from a nearby one, else by bucket.
#pragma once

#include "krait/scene.hpp"

namespace krait::detail {

// The triangle whose closed area contains p, exactly, p being rounded to the scene's grid; kNone when p lies in an
// obstacle, outside, or is not finite. `hint` (or kNone) is where the walk starts: it has at most 16 steps, then the
// bucket's list decides. A point on a shared edge belongs to whichever of its triangles is met first.
Index locate(const Scene& scene, Vec2 p, Index hint = kNone);

}  // namespace krait::detail
