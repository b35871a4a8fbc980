// SPDX-License-Identifier: Apache-2.0
#include "host/reduce/closed.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host/reduce/cell_distances.hpp"
#include "host/reduce/cells.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

// Sets of free cells, joined side by side (Tarjan 1975), and whether a part of the free space of `after` is among them.
class Parts {
 public:
  explicit Parts(std::size_t cells) : parents_(cells), known_(cells, 0), joined_(cells, 0) {
    std::iota(parents_.begin(), parents_.end(), 0U);
  }

  void add(std::size_t cell, bool known) {
    joined_[cell] = 1;
    known_[cell] = known;
  }
  bool has(std::size_t cell) const { return joined_[cell] != 0; }

  // Whether that joins two known parts.
  bool join(std::size_t a, std::size_t b) {
    const std::uint32_t from = root(a), to = root(b);
    if (from == to) return false;
    parents_[from] = to;
    const bool both = known_[from] != 0 && known_[to] != 0;
    known_[to] |= known_[from];
    return both;
  }

 private:
  std::uint32_t root(std::size_t cell) {
    auto at = static_cast<std::uint32_t>(cell);
    while (parents_[at] != at) at = parents_[at] = parents_[parents_[at]];
    return at;
  }

  std::vector<std::uint32_t> parents_;
  CellMask known_, joined_;
};

}  // namespace

// The free cells of `before` that are not free in `after` come back one by one, the one with the most room first: where
// one joins two parts, every other way between them is narrower.
std::vector<ClosedPassage> closed_passages(const CellMap& before, const CellMap& after) {
  const CellFrame frame(before), frame_after(after);
  const auto stays_free = [&](std::size_t cell) {
    const auto there = cell_at(after, frame_after, middle(before, frame, cell));
    return there && after.occupied[*there] == 0;
  };
  Parts parts(before.occupied.size());
  std::vector<std::size_t> lost;
  const auto join = [&](std::size_t cell) {
    bool passage = false;
    each_neighbor(before, cell, [&](std::size_t other, bool side) {
      if (side && parts.has(other)) passage = parts.join(cell, other) || passage;
    });
    return passage;
  };
  for (std::size_t cell = 0; cell < before.occupied.size(); ++cell) {
    if (before.occupied[cell] != 0) continue;
    if (!stays_free(cell)) {
      lost.push_back(cell);
      continue;
    }
    parts.add(cell, true);
    join(cell);
  }
  const std::vector<std::uint32_t> distances = squared_distances(before.occupied, before.columns, Beyond::marked);
  std::stable_sort(lost.begin(), lost.end(), [&](auto a, auto b) { return distances[a] > distances[b]; });
  std::vector<ClosedPassage> passages;
  for (const std::size_t cell : lost) {
    parts.add(cell, false);
    if (!join(cell)) continue;
    const double room = 2 * std::sqrt(double(distances[cell])) - 1;
    passages.push_back({middle(before, frame, cell), room * before.resolution});
  }
  return passages;
}

void warn_of_closed(const std::vector<ClosedPassage>& passages, const std::string& option,
                    std::vector<std::string>& warnings) {
  constexpr std::size_t kNamed = 3;
  for (std::size_t i = 0; i < std::min(passages.size(), kNamed); ++i) {
    const ClosedPassage& p = passages[i];
    warnings.push_back(option +
                       printed(" closes a passage at %.6g,%.6g, at least %.3g m wide", p.place.x, p.place.y, p.width));
  }
  if (passages.size() > kNamed)
    warnings.push_back(option + printed(" closes %zu narrower passages, too", passages.size() - kNamed));
}

}  // namespace krait::host
