// SPDX-License-Identifier: Apache-2.0
// Which regions' edges one failure raises, by its definition (Regions::raise_edges).
#pragma once

#include <algorithm>
#include <vector>

#include "krait/scene.hpp"

namespace krait::test {

// The region and, breadth first, those that joins(a, b) connects with it and whose apart(region, b), metres, is below
// `reach`: at most 32 in all.
template <class Joins, class Apart>
std::vector<Index> regions_around(const Scene& scene, Index region, double reach, Joins joins, Apart apart) {
  std::vector<Index> found = {region};
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (int edge = 0; edge < 3 && found.size() < 32; ++edge) {
      const Index n = scene.neighbor(found[i], edge);
      if (n == kNone || !joins(found[i], n) || apart(region, n) >= reach) continue;
      if (std::find(found.begin(), found.end(), n) == found.end()) found.push_back(n);
    }
  }
  return found;
}

}  // namespace krait::test
