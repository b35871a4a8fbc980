// SPDX-License-Identifier: GPL-3.0-or-later
// A uniform grid of square cells over a box, for finding what lies near a segment or a triangle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "host/compiler/geometry.hpp"

namespace krait::host::compiler {

class CellIndex {
 public:
  // About `cells` cells over the box.
  CellIndex(const GridBox& box, std::size_t cells) : min_(box.min) {
    const double width = double(box.max.x) - box.min.x + 1;
    const double height = double(box.max.y) - box.min.y + 1;
    const double count = std::clamp(double(cells), 1.0, 4e6);
    // A thin box gets no more cells than asked for.
    size_ = std::max({1.0, std::sqrt(width * height / count), width / count, height / count});
    columns_ = static_cast<std::int64_t>(width / size_) + 1;
    rows_ = static_cast<std::int64_t>(height / size_) + 1;
  }

  std::size_t cells() const { return static_cast<std::size_t>(columns_ * rows_); }

  std::size_t cell_of(GridPoint p) const { return index(column(p.x), row(p.y)); }

  // Calls visit(cell) for every cell that comes within one grid step of the segment or convex polygon (of 2 or more
  // points), and perhaps for a few more.
  template <class Visit>
  void near(std::span<const GridPoint> points, Visit visit) const {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(), [](auto a, auto b) { return a.y < b.y; });
    const std::int64_t last = row(high->y + 1.0);
    for (std::int64_t j = row(low->y - 1.0); j <= last; ++j) {
      const auto [from, to] = span_in_row(points, min_.y + double(j) * size_ - 2, min_.y + double(j + 1) * size_ + 2);
      for (std::int64_t i = column(from - 2), end = column(to + 2); i <= end; ++i) visit(index(i, j));
    }
  }

 private:
  std::int64_t column(double x) const {
    return std::clamp(static_cast<std::int64_t>(std::floor((x - min_.x) / size_)), std::int64_t{0}, columns_ - 1);
  }
  std::int64_t row(double y) const {
    return std::clamp(static_cast<std::int64_t>(std::floor((y - min_.y) / size_)), std::int64_t{0}, rows_ - 1);
  }
  std::size_t index(std::int64_t i, std::int64_t j) const { return static_cast<std::size_t>(j * columns_ + i); }

  // The x range of the part of the convex outline with y in [low, high]; falls back to the whole range.
  static std::pair<double, double> span_in_row(std::span<const GridPoint> points, double low, double high) {
    double from = 1e18, to = -1e18;
    for (std::size_t k = 0; k < points.size(); ++k) {
      GridPoint a = points[k], b = points[(k + 1) % points.size()];
      if (a.y > b.y) std::swap(a, b);
      if (b.y < low || a.y > high) continue;
      const double slope = a.y == b.y ? 0 : (double(b.x) - a.x) / (double(b.y) - a.y);
      const double x0 = a.y >= low ? a.x : a.x + (low - a.y) * slope;
      const double x1 = b.y <= high ? b.x : a.x + (high - a.y) * slope;
      from = std::min({from, x0, x1});
      to = std::max({to, x0, x1});
    }
    return {from, to};
  }

  GridPoint min_;
  double size_ = 1;
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
};

// Items listed by cell: two passes, first add() for every item with counting, then again to fill.
class CellLists {
 public:
  // for_each(emit) calls emit(cell, item) for every entry, the same ones in both of two calls.
  template <class ForEach>
  CellLists(std::size_t cells, ForEach for_each) : offsets_(cells + 1, 0) {
    for_each([&](std::size_t cell, std::uint32_t) { ++offsets_[cell + 1]; });
    for (std::size_t i = 1; i < offsets_.size(); ++i) offsets_[i] += offsets_[i - 1];
    items_.resize(offsets_.back());
    std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
    for_each([&](std::size_t cell, std::uint32_t item) { items_[next[cell]++] = item; });
  }

  std::size_t cells() const { return offsets_.size() - 1; }
  std::size_t size() const { return items_.size(); }
  std::span<const std::uint32_t> at(std::size_t cell) const {
    return {items_.data() + offsets_[cell], offsets_[cell + 1] - offsets_[cell]};
  }

 private:
  std::vector<std::size_t> offsets_;
  std::vector<std::uint32_t> items_;
};

}  // namespace krait::host::compiler
