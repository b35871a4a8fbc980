// SPDX-License-Identifier: Apache-2.0
#include "plan/motion_tree.hpp"

#include "krait/status.hpp"

namespace krait::detail {

void MotionTree::allocate(Arena& arena, std::uint32_t vertices, std::uint32_t expansions, int state_size) {
  forget();
  vertex_capacity_ = vertices;
  expansion_capacity_ = expansions;
  state_size_ = static_cast<std::size_t>(state_size);
  records_ = arena.allocate<Expansion>(Pool::expansions, expansions);
  branches_ = arena.allocate<std::uint32_t>(Pool::vertices, vertices);
  states_ = arena.allocate<float>(Pool::states, vertices, static_cast<std::uint32_t>(state_size));
}

void MotionTree::reset(const Box& bounds, std::uint32_t spare) {
  forget();
  spare_ = spare;
  grid_ = TargetGrid(bounds);
}

void MotionTree::forget() {
  clear();
  vertex_most_ = 0;
  expansion_most_ = 0;
}

void MotionTree::clear() {
  vertex_most_ = most_vertices();
  expansion_most_ = most_expansions();
  vertices_ = 0;
  expansions_ = 0;
  vertex_high_ = 0;
  expansion_high_ = 0;
  free_vertex_ = kNone;
  free_expansion_ = kNone;
}

std::uint64_t MotionTree::bytes_untouched() const {
  const std::uint64_t vertex_bytes = sizeof(std::uint32_t) + state_size_ * sizeof(float);
  return (vertex_capacity_ - most_vertices()) * vertex_bytes +
         (expansion_capacity_ - most_expansions()) * sizeof(Expansion);
}

Index MotionTree::begin_expansion(Branch from, const Target& target) {
  KRAIT_ASSERT(expansions_ < expansion_capacity_);
  const Index expansion = free_expansion_ == kNone ? expansion_high_++ : free_expansion_;
  Expansion& record = records_[expansion];
  if (expansion == free_expansion_) free_expansion_ = record.origin;
  record = {packed(from), kUse, grid_.pack(target)};
  use(from);
  ++expansions_;
  return expansion;
}

void MotionTree::end_expansion(Index expansion, std::uint32_t steps) {
  KRAIT_ASSERT(expansion < expansion_high_ && steps <= kMostSteps);
  set_steps(records_[expansion], steps);
  release({expansion, 0});
}

Branch MotionTree::origin(Index expansion) const { return unpacked(records_[expansion].origin); }

Index MotionTree::add(Branch branch, const float* state) {
  KRAIT_ASSERT(!vertices_full());
  const Index vertex = free_vertex_ == kNone ? vertex_high_++ : free_vertex_;
  if (vertex == free_vertex_) free_vertex_ = branches_[vertex];
  ++vertices_;
  write(vertex, branch, state);
  return vertex;
}

void MotionTree::replace(Index vertex, Branch by, const float* state) {
  KRAIT_ASSERT(vertex < vertex_high_);
  const Branch before = branch(vertex);
  write(vertex, by, state);
  release(before);
}

void MotionTree::remove(Index vertex) {
  KRAIT_ASSERT(vertex < vertex_high_);
  const Branch before = branch(vertex);
  branches_[vertex] = free_vertex_;
  free_vertex_ = vertex;
  --vertices_;
  release(before);
}

void MotionTree::write(Index vertex, Branch branch, const float* state) {
  branches_[vertex] = packed(branch);
  float* const copy = states_ + std::size_t{vertex} * state_size_;
  for (std::size_t i = 0; i < state_size_; ++i) copy[i] = state[i];
  use(branch);
}

// An expansion that nothing needs any more goes, and no longer needs the one before it. O(expansions that go).
void MotionTree::release(Branch branch) {
  for (Index expansion = branch.expansion; expansion != kNone;) {
    Expansion& record = records_[expansion];
    record.steps_and_uses -= kUse;
    if (record.steps_and_uses >= kUse) return;
    const Index before = unpacked(record.origin).expansion;
    record.origin = free_expansion_;
    free_expansion_ = expansion;
    --expansions_;
    expansion = before;
  }
}

Index MotionTree::turn_path(Branch last) {
  KRAIT_ASSERT(last.expansion < expansion_high_);
  Branch at = last;
  Index after = kNone;
  for (;;) {
    Expansion& record = records_[at.expansion];
    const Branch before = unpacked(record.origin);
    record.origin = packed({after, 0});
    set_steps(record, at.step);
    after = at.expansion;
    if (before.expansion == kNone) return after;
    at = before;
  }
}

void MotionTree::turn_path_back(Index first) {
  Branch before;
  for (Index expansion = first; expansion != kNone;) {
    const Index after = next_of_path(expansion);
    records_[expansion].origin = packed(before);
    before = {expansion, steps(expansion)};
    expansion = after;
  }
}

}  // namespace krait::detail
