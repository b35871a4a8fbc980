// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/mesh.hpp"

#include <algorithm>

#include "host/compiler/snap.hpp"

namespace krait::host::compiler {
namespace {

bool free(const Face& face) { return face.winding[0] != 0; }

// Edges between faces that differ, one of them free.
Edges dividing_edges(const Triangulation& t) {
  Edges edges;
  for (std::uint32_t f = 0; f < t.faces.size(); ++f) {
    const Face& face = t.faces[f];
    if (!free(face)) continue;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t other = face.neighbors[i];
      const bool open = other != kNone && free(t.faces[other]);
      const Winding right = open ? t.faces[other].winding : Winding{0, 0};
      if (right == face.winding || (open && other < f)) continue;
      edges.push_back(
          {t.corner(face, i), t.corner(face, i + 1), {face.winding[0] - right[0], face.winding[1] - right[1]}});
    }
  }
  return edges;
}

Mesh free_faces(const Triangulation& t) {
  Mesh mesh;
  std::vector<std::uint32_t> triangle_of(t.faces.size(), kNone), vertex_of(t.points.size(), kNone);
  std::uint32_t count = 0;
  for (std::uint32_t f = 0; f < t.faces.size(); ++f) {
    if (free(t.faces[f])) triangle_of[f] = count++;
  }
  for (const Face& face : t.faces) {
    if (!free(face)) continue;
    FreeTriangle triangle{};
    for (int i = 0; i < 3; ++i) {
      std::uint32_t& vertex = vertex_of[face.corners[i]];
      if (vertex == kNone) {
        vertex = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(t.points[face.corners[i]]);
      }
      triangle.corners[i] = vertex;
      triangle.neighbors[i] = face.neighbors[i] == kNone ? kNone : triangle_of[face.neighbors[i]];
    }
    triangle.goal = face.winding[1] > 0 ? static_cast<std::uint32_t>(face.winding[1] - 1) : kNone;
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

MeshSize mesh_size(const GridBox& bounds, std::size_t edges, bool coarse) {
  const double extent = double(std::max(bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y));
  return {extent / 10, coarse ? extent / 10 : extent / 500, 5'000 + 20 * edges};
}

}  // namespace

Mesh free_mesh(const Edges& edges, const GridBox& bounds, bool coarse) {
  const Edges dividing = snap(dividing_edges(triangulate(edges))).edges;
  if (dividing.empty()) return {};
  const std::vector<GridPoint> added = refinement(dividing, mesh_size(bounds, dividing.size(), coarse));
  return free_faces(triangulate(snap(dividing, added).edges, added));
}

}  // namespace krait::host::compiler
