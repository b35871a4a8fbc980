// SPDX-License-Identifier: Apache-2.0
#include "host/import/fill.hpp"

#include <algorithm>

#include "host/workspace/ring.hpp"

namespace krait::host {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

const Point& next(const Ring& ring, std::size_t i) { return ring[i + 1 < ring.size() ? i + 1 : 0]; }

bool overlap(double a, double b, double c, double d) {
  return std::max(std::min(a, b), std::min(c, d)) <= std::min(std::max(a, b), std::max(c, d));
}

// Touching counts.
bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (!overlap(a.x, b.x, c.x, d.x) || !overlap(a.y, b.y, c.y, d.y)) return false;
  const double c_side = cross(a, b, c), d_side = cross(a, b, d);
  const double a_side = cross(c, d, a), b_side = cross(c, d, b);
  const auto apart = [](double p, double q) { return (p > 0 && q > 0) || (p < 0 && q < 0); };
  return !apart(c_side, d_side) && !apart(a_side, b_side);
}

bool meet(const Ring& one, const Ring& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t k = 0; k < other.size(); ++k) {
      if (meet(one[i], next(one, i), other[k], next(other, k))) return true;
    }
  }
  return false;
}

// Beyond the corners that edges share with the next.
bool meets_itself(const Ring& ring) {
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const std::size_t first = i + 1 == ring.size() ? 1 : 0;
    for (std::size_t k = first; k + 1 < i; ++k) {
      if (meet(ring[i], next(ring, i), ring[k], ring[k + 1])) return true;
    }
  }
  return false;
}

bool inside(const Ring& ring, const Point& p) {
  bool in = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = next(ring, i);
    if ((a.y > p.y) != (b.y > p.y) && (cross(a, b, p) > 0) == (b.y > a.y)) in = !in;
  }
  return in;
}

std::vector<Obstacle> each_alone(const std::string& label, std::vector<Ring> rings) {
  std::vector<Obstacle> obstacles;
  obstacles.reserve(rings.size());
  for (Ring& ring : rings) obstacles.push_back({label, std::move(ring), {}});
  return obstacles;
}

// Rings that do not meet lie one in another or apart: a forest.
class Nesting {
 public:
  Nesting(const std::vector<Ring>& rings, FillRule rule) : rings_(rings), rule_(rule) {
    for (std::size_t i = 0; i < rings.size(); ++i) around_.push_back(winding_around(i));
  }

  // Whether just inside of the ring is filled; whether just outside of it is.
  bool fills(std::size_t ring) const { return is_filled(around_[ring] + own_winding(ring)); }
  bool lies_in_filled(std::size_t ring) const { return is_filled(around_[ring]); }

  // The innermost ring around it for which `wanted` holds.
  template <class Wanted>
  std::size_t around(std::size_t ring, const Wanted& wanted) const {
    std::size_t best = kNone;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      if (!contains(i, ring) || !wanted(i)) continue;
      if (best == kNone || contains(best, i)) best = i;
    }
    return best;
  }

 private:
  bool contains(std::size_t outer, std::size_t ring) const {
    return outer != ring && inside(rings_[outer], rings_[ring][0]);
  }

  int own_winding(std::size_t ring) const {
    return rule_ == FillRule::even_odd || twice_area(rings_[ring]) > 0 ? 1 : -1;
  }

  int winding_around(std::size_t ring) const {
    int winding = 0;
    for (std::size_t i = 0; i < rings_.size(); ++i) winding += contains(i, ring) ? own_winding(i) : 0;
    return winding;
  }

  bool is_filled(int winding) const { return rule_ == FillRule::even_odd ? winding % 2 != 0 : winding != 0; }

  const std::vector<Ring>& rings_;
  FillRule rule_;
  std::vector<int> around_;  // each ring: the winding number just outside of it
};

// Whether the work suffices to compare every edge with every other and to nest all rings; subtracts it if so.
bool spend(const std::vector<Ring>& rings, std::size_t& work) {
  double edges = 0;
  for (const Ring& ring : rings) edges += static_cast<double>(ring.size());
  const double needed = edges * (edges + 8 * static_cast<double>(rings.size()));
  if (needed > static_cast<double>(work)) return false;
  work -= static_cast<std::size_t>(needed);
  return true;
}

bool any_meet(const std::vector<Ring>& rings) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (meets_itself(rings[i])) return true;
    for (std::size_t k = 0; k < i; ++k) {
      if (meet(rings[i], rings[k])) return true;
    }
  }
  return false;
}

// Of outlines that meet: whether a corner of one lies within another, where the rule fills nothing.
bool any_hole(const std::vector<Ring>& rings, FillRule rule) {
  const auto within = [](const Ring& ring, const Point& p) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (meet(ring[i], next(ring, i), p, p)) return false;
    }
    return inside(ring, p);
  };
  for (const Ring& outer : rings) {
    for (const Ring& inner : rings) {
      const bool alike = (twice_area(outer) > 0) == (twice_area(inner) > 0);
      if (&inner == &outer || (rule == FillRule::nonzero && alike)) continue;
      if (std::any_of(inner.begin(), inner.end(), [&](const Point& p) { return within(outer, p); })) return true;
    }
  }
  return false;
}

}  // namespace

Filling filled(const std::string& label, std::vector<Ring> rings, FillRule rule, std::size_t& work) {
  std::erase_if(rings, [](const Ring& ring) { return ring.size() < 3; });
  if (rings.size() < 2 || !spend(rings, work)) return {each_alone(label, std::move(rings))};
  if (any_meet(rings)) {
    const bool loses_hole = any_hole(rings, rule);
    return {each_alone(label, std::move(rings)), loses_hole};
  }
  const Nesting nesting(rings, rule);
  std::vector<std::size_t> place(rings.size(), kNone);  // of outlines, in the obstacles
  std::vector<Obstacle> obstacles;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (!nesting.fills(i) || nesting.lies_in_filled(i)) continue;
    place[i] = obstacles.size();
    obstacles.push_back({label, rings[i], {}});
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (nesting.fills(i) || !nesting.lies_in_filled(i)) continue;
    const std::size_t outline = nesting.around(i, [&](std::size_t k) { return place[k] != kNone; });
    if (outline != kNone) obstacles[place[outline]].holes.push_back(rings[i]);
  }
  return {std::move(obstacles)};
}

}  // namespace krait::host
