// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/rings.hpp"

#include <tuple>

namespace krait::host::compiler {
namespace {

// Whether turning clockwise about `center` from `start` one meets a before b.
bool clockwise_before(GridPoint center, GridPoint start, GridPoint a, GridPoint b) {
  const auto turned_half = [&](GridPoint p) {
    const std::int64_t side = cross(center, start, p);
    return side > 0 || (side == 0 && dot(center, start, p) > 0);
  };
  const bool late_a = turned_half(a), late_b = turned_half(b);
  return late_a != late_b ? late_b : cross(center, a, b) < 0;
}

}  // namespace

std::vector<GridRing> rings_of(Edges edges) {
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
  std::vector<bool> used(edges.size(), false);
  const auto next_of = [&](const Edge& e) {
    auto best = edges.end();
    const auto first =
        std::lower_bound(edges.begin(), edges.end(), e.to, [](const Edge& a, GridPoint p) { return a.from < p; });
    for (auto it = first; it != edges.end() && it->from == e.to; ++it) {
      if (best == edges.end() || clockwise_before(e.to, e.from, it->to, best->to)) best = it;
    }
    return static_cast<std::size_t>(best - edges.begin());
  };
  std::vector<GridRing> rings;
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (used[first]) continue;
    GridRing ring;
    for (std::size_t i = first; !used[i]; i = next_of(edges[i])) {
      used[i] = true;
      ring.push_back(edges[i].from);
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace krait::host::compiler
