// SPDX-License-Identifier: GPL-3.0-or-later
// Boundaries between kinds of faces, as edges and as rings.
#pragma once

#include <algorithm>

#include "host/compiler/triangulation.hpp"

namespace krait::host::compiler {

// The edges with a face that `inside` accepts on their left and none on their right, with winding {1, 0}.
template <class Inside>
Edges boundary(const Triangulation& t, Inside inside) {
  Edges edges;
  for (const Face& face : t.faces) {
    if (!inside(face)) continue;
    for (int i = 0; i < 3; ++i) {
      if (face.neighbors[i] != kNone && inside(t.faces[face.neighbors[i]])) continue;
      edges.push_back({t.corner(face, i), t.corner(face, i + 1), {1, 0}});
    }
  }
  return edges;
}

// Joins boundary edges to rings with the inside on the left. Where several rings meet in a point, each keeps to its
// own wedge of the inside, so that two parts that touch in a point stay apart.
std::vector<GridRing> rings_of(Edges edges);

}  // namespace krait::host::compiler
