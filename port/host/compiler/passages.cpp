// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/passages.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace krait::host::compiler {
namespace {

constexpr double kTouch = 1;  // grid steps: an edge so near to the segment's line, or behind it, is not across from it
constexpr double kCosine = -0.5;  // of the angle between two edges that face each other with free space on the left

// The rectangle on the left of a segment, from its line to `width` away.
class Strip {
 public:
  Strip(GridPoint a, GridPoint b, double width)
      : a_(a), b_(b), length_(std::hypot(double(b.x) - a.x, double(b.y) - a.y)), width_(width) {}

  std::array<GridPoint, 4> corners() const {
    const double across = width_ / length_;
    const auto dx = static_cast<std::int32_t>(std::lround(across * (double(a_.y) - b_.y)));
    const auto dy = static_cast<std::int32_t>(std::lround(across * (double(b_.x) - a_.x)));
    return {a_, b_, {b_.x + dx, b_.y + dy}, {a_.x + dx, a_.y + dy}};
  }

  bool faces(const Edge& e) const {
    const double along = double(dot(a_, b_, e.to)) - double(dot(a_, b_, e.from));
    return along < kCosine * length_ * std::hypot(double(e.to.x) - e.from.x, double(e.to.y) - e.from.y);
  }

  // Whether a part of the edge, and not only a point of it, lies inside.
  bool holds_part_of(const Edge& e) const {
    double from = 0, to = 1;
    const auto clip = [&](std::int64_t at_from, std::int64_t at_to, double least, double most) {
      const double start = double(at_from) / length_, way = double(at_to - at_from) / length_;
      if (way == 0) {
        if (start <= least || start >= most) to = -1;
        return;
      }
      const double first = (least - start) / way, last = (most - start) / way;
      from = std::max(from, std::min(first, last));
      to = std::min(to, std::max(first, last));
    };
    clip(dot(a_, b_, e.from), dot(a_, b_, e.to), 0, length_);
    clip(cross(a_, b_, e.from), cross(a_, b_, e.to), kTouch, width_);
    return from < to;
  }

 private:
  GridPoint a_, b_;
  double length_, width_;
};

GridBox box_of(const Edges& edges) {
  GridBox box{edges.front().from, edges.front().from};
  for (const Edge& e : edges) box = extended(box, e.from);
  return box;
}

}  // namespace

Passages::Passages(const std::vector<GridRing>& rings, double width)
    : edges_(edges_of(rings)),
      width_(width),
      index_(edges_.empty() ? GridBox{} : box_of(edges_), edges_.size()),
      lists_(index_.cells(), [this](auto emit) {
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
          index_.near(std::array{edges_[i].from, edges_[i].to}, [&](std::size_t cell) { emit(cell, i); });
        }
      }) {}

bool Passages::narrow(GridPoint a, GridPoint b) const {
  const Strip strip(a, b, width_);
  bool found = false;
  index_.near(strip.corners(), [&](std::size_t cell) {
    if (found) return;
    const auto here = lists_.at(cell);
    found = std::any_of(here.begin(), here.end(),
                        [&](std::uint32_t i) { return strip.faces(edges_[i]) && strip.holds_part_of(edges_[i]); });
  });
  return found;
}

}  // namespace krait::host::compiler
