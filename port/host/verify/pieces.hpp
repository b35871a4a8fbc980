// SPDX-License-Identifier: Apache-2.0
// Cuts a drawn obstacle of any shape into convex pieces.
#pragma once

#include <vector>

#include "host/workspace/workspace.hpp"

namespace krait::host {

// Whether the point lies inside the ring by the even-odd rule. Boundary points may count either way.
bool inside(const Ring& ring, const Point& point);

// Trapezoids that together cover what is inside `outer` and in no hole, each ring by the even-odd rule, so that rings
// may cross themselves and each other. Parts thinner than 1e-12 m are left out.
// Throws InputError, naming the obstacle, if a coordinate is not finite or the rings cross millions of times.
std::vector<Ring> convex_pieces(const Obstacle& obstacle);

}  // namespace krait::host
