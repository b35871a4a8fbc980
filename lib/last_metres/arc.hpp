// SPDX-License-Identifier: Apache-2.0
// Arcs and straight lines that begin with a pose, and the directions of poses.
#pragma once

#include "krait/geometry.hpp"

namespace krait::detail {

inline Vec2 direction(SinCos heading) { return {heading.cos, heading.sin}; }
inline Vec2 left_of(Vec2 a) { return {-a.y, a.x}; }
inline SinCos opposite(SinCos heading) { return {-heading.sin, -heading.cos}; }

// The pose `way` metres along the circle of `radius` metres, above 0, whose centre lies to the left (1) or the right
// (-1) of `from`, or straight ahead (0); behind it where `way` is negative.
Pose along(const Pose& from, int turn, float radius, float way);

}  // namespace krait::detail
