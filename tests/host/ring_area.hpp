// SPDX-License-Identifier: Apache-2.0
// The area of a ring, by other terms than the importers' own.
#pragma once

#include "host/workspace/workspace.hpp"

namespace krait::host {

// Square metres, above 0 where it is counter-clockwise.
inline double area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    sum += (a.x * b.y - b.x * a.y) / 2;
  }
  return sum;
}

}  // namespace krait::host
