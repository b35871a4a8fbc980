// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/cell_distances.hpp"

#include <algorithm>
#include <cstddef>

namespace krait::host {
namespace {

constexpr std::uint32_t kFar = 46'341;  // cells; its square is kFarSquared, rounded up

// Distances along the columns, up to kFar.
std::vector<std::uint32_t> along_columns(const CellMask& marked, std::size_t columns, Beyond beyond) {
  const std::uint32_t outside = beyond == Beyond::marked ? 0 : kFar;
  std::vector<std::uint32_t> distances(marked.size());
  const auto sweep = [&](std::size_t i, bool at_border, std::size_t before) {
    const std::uint32_t reached = (at_border ? outside : distances[before]) + 1;
    distances[i] = marked[i] != 0 ? 0 : std::min({distances[i], reached, kFar});
  };
  std::fill(distances.begin(), distances.end(), kFar);
  for (std::size_t i = 0; i < marked.size(); ++i) sweep(i, i < columns, i - columns);
  for (std::size_t i = marked.size(); i-- > 0;) sweep(i, i + columns >= marked.size(), i + columns);
  return distances;
}

// The lower envelope of one parabola for each cell of a row.
class Envelope {
 public:
  // `heights` are the distances along the columns, with one more cell at either end.
  void find(const std::vector<std::int64_t>& heights) {
    heights_ = &heights;
    parabolas_.clear();
    for (std::int64_t u = 0; u < std::int64_t(heights.size()); ++u) add(u);
  }

  // Calls visit(place, squared distance) for all places, the last first.
  template <class Visit>
  void each(Visit visit) const {
    std::size_t p = parabolas_.size();
    for (std::int64_t u = std::int64_t(heights_->size()) - 1; u >= 0; --u) {
      while (parabolas_[p - 1].first > u) --p;
      visit(std::size_t(u), at(u, parabolas_[p - 1].apex));
    }
  }

 private:
  struct Parabola {
    std::int64_t apex, first;  // the first place where it is the lowest
  };

  std::int64_t height(std::int64_t apex) const { return (*heights_)[std::size_t(apex)]; }
  std::int64_t at(std::int64_t u, std::int64_t apex) const {
    return (u - apex) * (u - apex) + height(apex) * height(apex);
  }
  // The last place where the parabola of `left` is not above that of `right`, as it is at some place from 0 on.
  std::int64_t last_of(std::int64_t left, std::int64_t right) const {
    const std::int64_t up = right * right - left * left + height(right) * height(right) - height(left) * height(left);
    return up / (2 * (right - left));
  }

  void add(std::int64_t u) {
    while (!parabolas_.empty() && at(parabolas_.back().first, parabolas_.back().apex) > at(parabolas_.back().first, u))
      parabolas_.pop_back();
    const std::int64_t first = parabolas_.empty() ? 0 : last_of(parabolas_.back().apex, u) + 1;
    if (first < std::int64_t(heights_->size())) parabolas_.push_back({u, first});
  }

  const std::vector<std::int64_t>* heights_ = nullptr;
  std::vector<Parabola> parabolas_;
};

}  // namespace

std::vector<std::uint32_t> squared_distances(const CellMask& marked, int columns, Beyond beyond) {
  const auto width = static_cast<std::size_t>(columns);
  std::vector<std::uint32_t> distances = along_columns(marked, width, beyond);
  std::vector<std::int64_t> heights(width + 2, beyond == Beyond::marked ? 0 : kFar);
  Envelope envelope;
  for (std::size_t row = 0; row < distances.size(); row += width) {
    std::copy_n(distances.begin() + std::ptrdiff_t(row), width, heights.begin() + 1);
    envelope.find(heights);
    envelope.each([&](std::size_t u, std::int64_t squared) {
      if (u > 0 && u <= width) distances[row + u - 1] = std::uint32_t(std::min<std::int64_t>(squared, kFarSquared));
    });
  }
  return distances;
}

}  // namespace krait::host
