// SPDX-License-Identifier: Apache-2.0
// Points and convex shapes as Boost.Geometry knows them.
#pragma once

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/register/point.hpp>

#include "host/workspace/workspace.hpp"

BOOST_GEOMETRY_REGISTER_POINT_2D(krait::host::Point, double, cs::cartesian, x, y)

namespace krait::host {

using Convex = boost::geometry::model::ring<Point>;  // closed, clockwise
using Box = boost::geometry::model::box<Point>;

inline Convex hull_of(const Ring& points) {
  Convex hull;
  boost::geometry::convex_hull(boost::geometry::model::multi_point<Point>(points.begin(), points.end()), hull);
  return hull;
}

}  // namespace krait::host
