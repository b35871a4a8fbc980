// SPDX-License-Identifier: Apache-2.0
// Where the cells of a map lie in the world.
#pragma once

#include <cmath>

#include "host/workspace/workspace.hpp"

namespace krait::host {

// Between the world, in metres, and the map's own frame, in cells: (0, 0) is the lower left corner of its first cell.
class CellFrame {
 public:
  explicit CellFrame(const CellMap& map)
      : origin_(map.origin), resolution_(map.resolution), cos_(std::cos(map.yaw)), sin_(std::sin(map.yaw)) {}

  Point world(double column, double row) const {
    const double x = column * resolution_, y = row * resolution_;
    return {origin_.x + cos_ * x - sin_ * y, origin_.y + sin_ * x + cos_ * y};
  }

  Point cells(Point world) const {
    const double x = (world.x - origin_.x) / resolution_, y = (world.y - origin_.y) / resolution_;
    return {cos_ * x + sin_ * y, cos_ * y - sin_ * x};
  }

 private:
  Point origin_;
  double resolution_;
  double cos_, sin_;
};

}  // namespace krait::host
