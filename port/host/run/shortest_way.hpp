// SPDX-License-Identifier: Apache-2.0
// How long the way of a plan must be, as far as the scene's regions know.
#pragma once

#include "krait/goal.hpp"
#include "krait/scene.hpp"

namespace krait::host {

// Metres from `from` to `to`, a point of the goal, through portals of at least `least_width` metres: the shortest way
// over seven points of each portal, straightened where its points see each other. Some per cent longer than the
// shortest of all. NaN where there is none. Local coordinates. O(R log R).
double shortest_way(const krait::Scene& scene, const krait::Goal& goal, float least_width, Vec2 from, Vec2 to);

}  // namespace krait::host
