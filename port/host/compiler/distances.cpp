// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/distances.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <limits>

#include "host/compiler/lipschitz.hpp"

namespace krait::host::compiler {
namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::d2::point_xy<double>;
using TreeBox = bg::model::box<TreePoint>;
using TreeSegment = bg::model::segment<TreePoint>;

TreePoint point(GridPoint p) { return {double(p.x), double(p.y)}; }

std::vector<TreeSegment> segments(const Edges& edges) {
  std::vector<TreeSegment> result;
  result.reserve(edges.size());
  for (const Edge& e : edges) result.emplace_back(point(e.from), point(e.to));
  return result;
}

constexpr double kSlack = 8;      // grid steps
constexpr double kShare = 0.005;  // of the distance

}  // namespace

struct Distances::Tree {
  explicit Tree(const Edges& edges) : index(segments(edges)) {}

  template <class Shape>
  double nearest(const Shape& shape) const {
    const auto found = index.qbegin(bg::index::nearest(shape, 1));
    if (found == index.qend()) return std::numeric_limits<double>::infinity();
    return bg::distance(shape, *found);
  }

  bg::index::rtree<TreeSegment, bg::index::quadratic<16>> index;
};

Distances::Distances(const Edges& boundary) : tree_(std::make_unique<Tree>(boundary)) {}
Distances::~Distances() = default;

double Distances::to_point(double x, double y) const { return tree_->nearest(TreePoint(x, y)); }

double Distances::to_box(const GridBox& box) const { return tree_->nearest(TreeBox(point(box.min), point(box.max))); }

double Distances::width(GridPoint a, GridPoint b) const {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, length = std::hypot(dx, dy);
  const auto clearance = [&](double t) { return to_point(a.x + dx * t / length, a.y + dy * t / length); };
  return 2 * maximum(clearance, length, kSlack, kShare);
}

}  // namespace krait::host::compiler
