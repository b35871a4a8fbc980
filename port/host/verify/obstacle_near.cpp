// SPDX-License-Identifier: Apache-2.0
#include "host/verify/obstacle_near.hpp"

#include "host/verify/obstacles.hpp"

namespace krait::host {

std::string obstacle_near(const Workspace& workspace, const Point& at, double reach) {
  constexpr double kSide = 1e-6;  // m, of the square that stands for the place
  const Point low{at.x - workspace.min.x, at.y - workspace.min.y};
  Convex place;
  boost::geometry::convert(Box{low, {low.x + kSide, low.y + kSide}}, place);
  return Obstacles(workspace).nearest(place, reach).obstacle;
}

}  // namespace krait::host
