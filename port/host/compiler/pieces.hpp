// SPDX-License-Identifier: GPL-3.0-or-later
// Convex decomposition of the solid faces (Hertel and Mehlhorn 1983), without new vertices.
#pragma once

#include <functional>
#include <vector>

#include "host/compiler/triangulation.hpp"

namespace krait::host::compiler {

// Strictly convex, counter-clockwise, 3-8 vertices each; their union is the solid faces exactly. A vertex of one may
// lie on an edge of another.
std::vector<GridRing> convex_pieces(const Triangulation& t, const std::function<bool(const Face&)>& solid);

}  // namespace krait::host::compiler
