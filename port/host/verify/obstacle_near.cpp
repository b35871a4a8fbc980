// SPDX-License-Identifier: Apache-2.0
#include "host/verify/obstacle_near.hpp"

#include "host/verify/obstacles.hpp"

namespace krait::host {

namespace {

// What stands for a place, in the coordinates of the workspace's obstacles.
Convex square_at(const Workspace& workspace, const Point& place) {
  constexpr double kSide = 1e-6;  // m
  const Point low{place.x - workspace.min.x, place.y - workspace.min.y};
  Convex square;
  boost::geometry::convert(Box{low, {low.x + kSide, low.y + kSide}}, square);
  return square;
}

}  // namespace

std::string obstacle_near(const Workspace& workspace, const Point& at, double reach) {
  return Obstacles(workspace).nearest(square_at(workspace, at), reach).obstacle;
}

std::vector<double> rooms_around(const Workspace& workspace, const std::vector<Point>& places, double most) {
  const Obstacles obstacles(workspace);
  std::vector<double> rooms;
  for (const Point& place : places) rooms.push_back(obstacles.nearest(square_at(workspace, place), most).distance);
  return rooms;
}

}  // namespace krait::host
