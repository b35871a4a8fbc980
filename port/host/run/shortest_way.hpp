// SPDX-License-Identifier: Apache-2.0
// How long the way of a plan must be at least, as far as the scene's regions know.
#pragma once

#include "krait/scene.hpp"

namespace krait::host {

// Metres: the shortest way for a point from `from` to `to` through portals of at least `least_width` metres, but for
// rounding. No way of a robot's reference point that keeps to such portals is shorter. NaN where there is none, or
// where an end lies in no region. Local coordinates. Of the regions around the shortest way mostly, at worst more than
// all.
double shortest_way(const krait::Scene& scene, float least_width, Vec2 from, Vec2 to);

}  // namespace krait::host
