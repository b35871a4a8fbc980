// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/unite.hpp"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "host/compiler/rings.hpp"
#include "host/compiler/snap.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host::compiler {
namespace {

constexpr std::size_t kGroup = 16;

bool solid(const Face& face) { return face.winding[0] != 0 && face.winding[1] == 0; }

std::int32_t quotient_up(std::int32_t up, std::int32_t down) {
  return (std::abs(up) + std::abs(down) - 1) / std::abs(down);
}
std::int32_t sign(std::int32_t x) { return x < 0 ? -1 : 1; }

// At most `widest` grid steps to the side of the edge that stays within the bounds. An edge from bound to bound leaves
// them at one end to either side: its neighbour ends on the bound.
Edges thin_wall(const Edge& e, const GridBox& bounds, std::int32_t widest) {
  const std::int32_t dx = e.to.x - e.from.x, dy = e.to.y - e.from.y;
  const bool flat = std::abs(dx) >= std::abs(dy);
  const std::int32_t room = flat ? bounds.max.y - bounds.min.y : bounds.max.x - bounds.min.x;
  const std::int32_t width = std::clamp(room / 2, 1, widest);
  const std::int32_t up = std::max(e.from.y, e.to.y) + width <= bounds.max.y ? width : -width;
  const std::int32_t right = std::max(e.from.x, e.to.x) + width <= bounds.max.x ? width : -width;
  const auto beside = [&](GridPoint p, int inwards) -> GridPoint {
    if (flat && p.y + up < bounds.min.y) return {p.x + inwards * sign(dx) * quotient_up(width * dx, dy), p.y};
    if (!flat && p.x + right < bounds.min.x) return {p.x, p.y + inwards * sign(dy) * quotient_up(width * dy, dx)};
    return flat ? GridPoint{p.x, p.y + up} : GridPoint{p.x + right, p.y};
  };
  GridRing ring{e.from, e.to, beside(e.to, -1), beside(e.from, 1)};
  if (twice_area(ring) < 0) std::reverse(ring.begin(), ring.end());
  Edges wall;
  append_ring(wall, ring, {1, 0});
  return wall;
}

// Edges of obstacles that are solid on neither side: what rounding has made of something thin.
Edges collapsed(const Edges& edges, const Triangulation& t, const GridBox& bounds) {
  Edges hidden;  // edges with a solid side
  for (const Face& face : t.faces) {
    if (!solid(face)) continue;
    for (int i = 0; i < 3; ++i) {
      const GridPoint a = t.corner(face, i), b = t.corner(face, i + 1);
      hidden.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  const auto before = [](const Edge& a, const Edge& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); };
  std::sort(hidden.begin(), hidden.end(), before);
  Edges result;
  for (const Edge& e : edges) {
    if (e.winding == Winding{0, 0} && !on_border(e, bounds) &&
        !std::binary_search(hidden.begin(), hidden.end(), e, before))
      result.push_back(e);
  }
  return result;
}

// Rounding may make a wall of one grid step collapse again, along a diagonal above all, so walls are added, and every
// second time wider ones, until nothing is lost.
United unite_group(Edges edges, const GridBox& bounds) {
  constexpr int kMostRounds = 50;  // two or three in practice
  int passes = 0;
  for (int round = 0; round < kMostRounds; ++round) {
    const Snapped snapped = snap(std::move(edges));
    passes += snapped.passes;
    const Triangulation t = triangulate(snapped.edges);
    edges = boundary(t, solid);
    const Edges lost = collapsed(snapped.edges, t, bounds);
    if (lost.empty()) return {std::move(edges), passes};
    for (const Edge& e : lost) {
      const Edges wall = thin_wall(e, bounds, 1 + round / 2);
      edges.insert(edges.end(), wall.begin(), wall.end());
    }
  }
  throw InputError("some obstacles are too thin for the scene's grid: widen or remove them");
}

// Interleaved bits of the middle of the edges: near parts get near keys.
std::uint64_t morton_key(const Edges& edges) {
  const Edge& e = edges.front();
  const auto spread = [](std::uint64_t v) {
    std::uint64_t result = 0;
    for (int bit = 0; bit < 32; ++bit) result |= ((v >> bit) & 1) << (2 * bit);
    return result;
  };
  constexpr std::int64_t kShift = std::int64_t{1} << 30;
  return spread(static_cast<std::uint64_t>(e.from.x + kShift)) | spread(static_cast<std::uint64_t>(e.from.y + kShift))
                                                                     << 1;
}

}  // namespace

United unite(std::vector<Edges> parts, const GridBox& bounds) {
  std::erase_if(parts, [](const Edges& part) { return part.empty(); });
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Edges& a, const Edges& b) { return morton_key(a) < morton_key(b); });
  int passes = 0;
  bool first = true;
  while (parts.size() > 1 || (first && !parts.empty())) {
    std::vector<Edges> larger;
    int most = 0;
    for (std::size_t i = 0; i < parts.size(); i += kGroup) {
      Edges group;
      for (std::size_t k = i; k < std::min(i + kGroup, parts.size()); ++k) {
        group.insert(group.end(), parts[k].begin(), parts[k].end());
      }
      United united = unite_group(std::move(group), bounds);
      most = std::max(most, united.passes);
      if (!united.boundary.empty()) larger.push_back(std::move(united.boundary));
    }
    passes += most;
    parts = std::move(larger);
    first = false;
  }
  return {parts.empty() ? Edges{} : std::move(parts.front()), passes};
}

}  // namespace krait::host::compiler
