// SPDX-License-Identifier: Apache-2.0
// The motion tree T = (V, E) (section 4.2), kept small. An expansion is a run of steps toward one target. It is
// determined by where it branches off, its target and its number of steps: whoever needs the states drives it again.
// Only the states that the search may grow from are kept as such.
#pragma once

#include <algorithm>

#include "base/arena.hpp"
#include "krait/geometry.hpp"
#include "krait/parameters.hpp"
#include "krait/status.hpp"
#include "plan/target_grid.hpp"

namespace krait::detail {

inline constexpr Index kRoot = 0;  // the vertex of the start, which stays

// A state of the tree: the one after `step` steps of an expansion.
struct Branch {
  Index expansion = kNone;
  std::uint32_t step = 0;
};

// A vertex is a state that is kept, in a slot of its own. Slots are reused.
class MotionTree {
 public:
  static constexpr std::uint32_t kMostExpansions = Limits::kMost;
  static constexpr std::uint32_t kMostSteps = (1U << 10U) - 1;  // of an expansion
  static_assert(SearchTuning::kMostSteps <= kMostSteps);

  // Room for `vertices` states of `state_size` floats, and `expansions`, at most kMostExpansions.
  void allocate(Arena& arena, std::uint32_t vertices, std::uint32_t expansions, int state_size);

  // Resets the tree. Targets are points of `bounds`, stored to 1/65535 of them. Of the expansions `spare` are kept back
  // for what ends a way: expansions_full() does not count on them.
  void reset(const Box& bounds, std::uint32_t spare);
  // Removes all vertices and expansions.
  void clear();

  std::uint32_t vertices() const { return vertices_; }
  std::uint32_t expansions() const { return expansions_; }
  std::uint32_t most_vertices() const { return std::max(vertex_most_, vertex_high_); }  // at any time since clear
  std::uint32_t most_expansions() const { return std::max(expansion_most_, expansion_high_); }
  // Bytes of the pools that were never written since clear.
  std::uint64_t bytes_untouched() const;
  bool vertices_full() const { return vertices_ == vertex_capacity_; }
  bool expansions_full() const { return expansions_ + spare_ >= expansion_capacity_; }

  // Begins an expansion, of no steps yet, from a state of the tree, or the root's with the branch {}. Not when full. It
  // stays, and all before it, until it has ended and is needed by no vertex and no later expansion.
  Index begin_expansion(Branch from, const Target& target);
  void end_expansion(Index expansion, std::uint32_t steps);

  // The target as stored; `dt` is not.
  Target target(Index expansion) const { return grid_.unpack(packed(expansion)); }
  const PackedTarget& packed(Index expansion) const { return records_[expansion].target; }
  Branch origin(Index expansion) const;
  std::uint32_t steps(Index expansion) const { return records_[expansion].steps_and_uses & kMostSteps; }

  // Keeps a state; not when full.
  Index add(Branch branch, const float* state);
  // Keeps it in place of another.
  void replace(Index vertex, Branch by, const float* state);
  void remove(Index vertex);

  const float* state(Index vertex) const {
    KRAIT_ASSERT(vertex < vertex_high_);
    return states_ + std::size_t{vertex} * state_size_;
  }
  Branch branch(Index vertex) const { return unpacked(branches_[vertex]); }

  // Turns the path that ends at `last` around: from then on next(root's expansion) is the expansion after it, and so
  // on, and steps() is how many of its steps the path has. Ends all other use of the tree, until the path is turned
  // back. Returns the first expansion.
  Index turn_path(Branch last);
  // Turns the path that begins with `first` back: the tree is again as before turn_path but for steps() of the path's
  // expansions, which nothing but a path reads.
  void turn_path_back(Index first);
  Index next_of_path(Index expansion) const { return origin(expansion).expansion; }

 private:
  struct Expansion {
    std::uint32_t origin;          // a packed branch
    std::uint32_t steps_and_uses;  // 10 bits, 22 bits: the vertices and expansions that need it, and 1 while it grows
    PackedTarget target;
  };

  // Clears the tree, and how much of it was in use.
  void forget();

  static constexpr std::uint32_t kUse = kMostSteps + 1;
  static constexpr std::uint32_t kNoBranch = 0xFFFFFFFF;

  static std::uint32_t packed(Branch b) { return b.expansion == kNone ? kNoBranch : b.expansion << 10U | b.step; }
  static Branch unpacked(std::uint32_t b) { return b == kNoBranch ? Branch{} : Branch{b >> 10U, b & kMostSteps}; }

  static void set_steps(Expansion& record, std::uint32_t steps) {
    record.steps_and_uses = record.steps_and_uses - (record.steps_and_uses & kMostSteps) + steps;
  }
  void use(Branch branch) {
    if (branch.expansion != kNone) records_[branch.expansion].steps_and_uses += kUse;
  }
  void release(Branch branch);
  void write(Index vertex, Branch branch, const float* state);

  Expansion* records_ = nullptr;
  std::uint32_t* branches_ = nullptr;  // of vertices, packed
  float* states_ = nullptr;
  std::size_t state_size_ = 0;
  std::uint32_t vertex_capacity_ = 0;
  std::uint32_t expansion_capacity_ = 0;
  std::uint32_t spare_ = 0;
  std::uint32_t vertices_ = 0;
  std::uint32_t expansions_ = 0;
  std::uint32_t vertex_high_ = 0;  // slots in use at some time since the tree was empty
  std::uint32_t expansion_high_ = 0;
  std::uint32_t vertex_most_ = 0;  // before that
  std::uint32_t expansion_most_ = 0;
  Index free_vertex_ = kNone;  // lists of unused slots, linked through branches_ and origins
  Index free_expansion_ = kNone;
  TargetGrid grid_;
};

}  // namespace krait::detail
