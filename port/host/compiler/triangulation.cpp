// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace krait::host::compiler {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using KernelPoint = Kernel::Point_2;

using VertexBase =
    CGAL::Delaunay_mesh_vertex_base_2<Kernel, CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>>;
using FaceBase =
    CGAL::Delaunay_mesh_face_base_2<Kernel,
                                    CGAL::Constrained_triangulation_face_base_2<
                                        Kernel, CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel>>>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

std::vector<GridPoint> points_of(const Edges& edges, std::vector<GridPoint> points) {
  for (const Edge& e : edges) points.insert(points.end(), {e.from, e.to});
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::uint32_t index_of(const std::vector<GridPoint>& points, GridPoint p) {
  return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
}

// Points must be sorted; each vertex's info is its point's index, each finite face's its number.
void fill(Cdt& cdt, const Edges& edges, const std::vector<GridPoint>& points) {
  std::vector<KernelPoint> places;
  for (const GridPoint p : points) places.emplace_back(p.x, p.y);
  std::vector<std::size_t> order(points.size());  // the index type that the sort's adapter asks for
  std::iota(order.begin(), order.end(), std::size_t{0});
  using Places = CGAL::Pointer_property_map<KernelPoint>::const_type;
  CGAL::spatial_sort(
      order.begin(), order.end(),
      CGAL::Spatial_sort_traits_adapter_2<Kernel, Places>(CGAL::make_property_map(std::as_const(places))));
  std::vector<Cdt::Vertex_handle> vertices(points.size());
  Cdt::Face_handle hint;
  for (const std::size_t i : order) {
    vertices[i] = cdt.insert(places[i], hint);
    vertices[i]->info() = static_cast<std::uint32_t>(i);
    hint = vertices[i]->face();
  }
  for (const Edge& e : edges)
    cdt.insert_constraint(vertices[index_of(points, e.from)], vertices[index_of(points, e.to)]);
  for (const auto face : cdt.all_face_handles()) face->info() = kNone;
  std::uint32_t count = 0;
  for (const auto face : cdt.finite_face_handles()) face->info() = count++;
}

Triangulation plain_copy(const Cdt& cdt, const std::vector<GridPoint>& points) {
  Triangulation result;
  result.points = points;
  for (const auto face : cdt.finite_face_handles()) {
    Face plain{};
    for (int i = 0; i < 3; ++i) {
      plain.corners[i] = face->vertex(i)->info();
      plain.neighbors[i] = face->neighbor(cdt.cw(i))->info();
    }
    result.faces.push_back(plain);
  }
  return result;
}

// Looks up the windings of edges by their ends.
class Windings {
 public:
  Windings(const Edges& edges, const std::vector<GridPoint>& points) {
    entries_.reserve(edges.size());
    for (const Edge& e : edges) entries_.push_back({index_of(points, e.from), index_of(points, e.to), e.winding});
    std::sort(entries_.begin(), entries_.end(), before);
  }

  // What crossing from the right of from → to to the left of it adds.
  Winding across(std::uint32_t from, std::uint32_t to) const {
    if (from > to) {
      const Winding back = across(to, from);
      return {-back[0], -back[1]};
    }
    const Entry wanted{from, to, {}};
    const auto found = std::lower_bound(entries_.begin(), entries_.end(), wanted, before);
    if (found == entries_.end() || found->from != from || found->to != to) return {0, 0};
    return found->winding;
  }

 private:
  struct Entry {
    std::uint32_t from, to;  // from < to
    Winding winding;
  };
  static bool before(const Entry& a, const Entry& b) { return std::pair(a.from, a.to) < std::pair(b.from, b.to); }

  std::vector<Entry> entries_;
};

void set_windings(Triangulation& t, const Windings& windings) {
  std::vector<bool> known(t.faces.size(), false);
  std::vector<std::uint32_t> waiting;
  const auto reach = [&](std::uint32_t face, Winding outside, Winding step) {
    if (known[face]) return;
    known[face] = true;
    t.faces[face].winding = {outside[0] + step[0], outside[1] + step[1]};
    waiting.push_back(face);
  };
  for (std::uint32_t f = 0; f < t.faces.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      if (t.faces[f].neighbors[i] != kNone) continue;
      reach(f, {0, 0}, windings.across(t.faces[f].corners[i], t.faces[f].corners[(i + 1) % 3]));
    }
  }
  while (!waiting.empty()) {
    const Face face = t.faces[waiting.back()];
    waiting.pop_back();
    for (int i = 0; i < 3; ++i) {
      if (face.neighbors[i] == kNone) continue;
      reach(face.neighbors[i], face.winding, windings.across(face.corners[(i + 1) % 3], face.corners[i]));
    }
  }
}

// A triangle is bad if it has too long an edge, or a small angle while it is large enough to matter.
class Criteria {
 public:
  explicit Criteria(const MeshSize& size)
      : largest_(size.largest * size.largest), smallest_(size.smallest * size.smallest) {}

  struct Quality {
    double excess = 0;  // squared longest edge over the squared limit, if above 1
    double shape = 0;   // squared sine of the smallest angle
    bool operator<(const Quality& other) const {
      return excess > 1 || other.excess > 1 ? excess > other.excess : shape < other.shape;
    }
  };

  class Is_bad {
   public:
    Is_bad(double largest, double smallest) : largest_(largest), smallest_(smallest) {}

    CGAL::Mesh_2::Face_badness operator()(const Quality& q) const {
      if (q.excess > 1) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return q.shape < kShape ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }

    CGAL::Mesh_2::Face_badness operator()(const Cdt::Face_handle& face, Quality& q) const {
      const KernelPoint &a = face->vertex(0)->point(), &b = face->vertex(1)->point(), &c = face->vertex(2)->point();
      double edges[] = {CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)};
      std::sort(edges, edges + 3);
      const double area = CGAL::to_double(CGAL::area(a, b, c));
      q.excess = edges[2] / largest_;
      q.shape = edges[2] < smallest_ ? 1 : 4 * area * area / (edges[1] * edges[2]);
      return (*this)(q);
    }

   private:
    static constexpr double kShape = 0.11;  // 19.4 degrees: within the bound for which refinement is known to end
    double largest_;
    double smallest_;
  };

  Is_bad is_bad_object() const { return {largest_, smallest_}; }

 private:
  double largest_;
  double smallest_;
};

Triangulation labelled(Cdt& cdt, const Edges& edges, const std::vector<GridPoint>& points) {
  fill(cdt, edges, points);
  Triangulation result = plain_copy(cdt, points);
  set_windings(result, Windings(edges, points));
  return result;
}

// Refines until no triangle is bad; false when there are too many vertices before that.
bool refine(Cdt& cdt, const Edges& edges, const std::vector<GridPoint>& points, const MeshSize& size) {
  const Triangulation coarse = labelled(cdt, edges, points);
  for (const auto face : cdt.all_face_handles()) {
    face->set_in_domain(face->info() != kNone && coarse.faces[face->info()].winding[0] != 0);
  }
  CGAL::Delaunay_mesher_2<Cdt, Criteria> mesher(cdt, Criteria(size));
  mesher.init(true);
  while (cdt.number_of_vertices() < size.most_points) {
    if (!mesher.step_by_step_refine_mesh()) return true;
  }
  return false;
}

}  // namespace

Triangulation triangulate(const Edges& edges, const std::vector<GridPoint>& extra) {
  Cdt cdt;
  return labelled(cdt, edges, points_of(edges, extra));
}

// Between edges that meet at very small angles refinement need not end: then it begins again, and leaves triangles of
// twice the size as they are.
std::vector<GridPoint> refinement(const Edges& edges, MeshSize size) {
  const std::vector<GridPoint> points = points_of(edges, {});
  Cdt cdt;
  while (!refine(cdt, edges, points, size) && size.smallest < size.largest) {
    cdt.clear();
    size.smallest *= 2;
  }
  std::vector<GridPoint> added;
  for (const auto vertex : cdt.finite_vertex_handles()) {
    const GridPoint p{static_cast<std::int32_t>(std::lround(vertex->point().x())),
                      static_cast<std::int32_t>(std::lround(vertex->point().y()))};
    if (!std::binary_search(points.begin(), points.end(), p)) added.push_back(p);
  }
  std::sort(added.begin(), added.end());
  added.erase(std::unique(added.begin(), added.end()), added.end());
  return added;
}

}  // namespace krait::host::compiler
