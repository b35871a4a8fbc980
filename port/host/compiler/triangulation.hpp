// SPDX-License-Identifier: GPL-3.0-or-later
// Constrained Delaunay triangulation of snapped edges, with the winding of every triangle, and its refinement.
#pragma once

#include <vector>

#include "host/compiler/geometry.hpp"

namespace krait::host::compiler {

struct Face {
  std::uint32_t corners[3];    // indices of points, counter-clockwise
  std::uint32_t neighbors[3];  // across the edge from corner i to corner i + 1; kNone outside the hull
  Winding winding;
};

struct Triangulation {
  std::vector<GridPoint> points;
  std::vector<Face> faces;  // cover the convex hull of the points

  GridPoint corner(const Face& face, int i) const { return points[face.corners[i % 3]]; }
  std::int64_t twice_area(const Face& face) const { return cross(corner(face, 0), corner(face, 1), corner(face, 2)); }
};

// The edges must be as snap() leaves them; no point may lie inside an edge.
Triangulation triangulate(const Edges& edges, const std::vector<GridPoint>& points = {});

struct MeshSize {
  double largest;           // grid steps: no edge gets longer
  double smallest;          // grid steps: triangles with shorter edges only may stay slender
  std::size_t most_points;  // beyond: `smallest` is doubled
};

// Points that make the triangles with winding[0] != 0 well-shaped and of a size that grows with the distance between
// the edges around them (Ruppert 1995, Shewchuk 1997), rounded to the grid: on the edges and off them.
std::vector<GridPoint> refinement(const Edges& edges, MeshSize size);

}  // namespace krait::host::compiler
