// SPDX-License-Identifier: Apache-2.0
// A way from the start, leg by leg: what an improved plan consists of. As in the motion tree, a leg is a run
// of steps toward one target, and whoever needs the states drives it again; some states are kept to begin from.
#pragma once

#include <limits>

#include "base/arena.hpp"
#include "krait/status.hpp"
#include "plan/target_grid.hpp"

namespace krait::detail {

struct Leg {
  static constexpr float kOffRoute = std::numeric_limits<float>::lowest();

  PackedTarget target;
  std::uint32_t steps;
  float arc;  // metres along the route that it follows, where it begins; kOffRoute: the way cannot change from there
};

class Way {
 public:
  static constexpr std::uint32_t kLegsAState = 16;

  // Room for `legs`, 16 bytes each, and a state for every kLegsAState of them.
  void allocate(Arena& arena, std::uint32_t legs, int state_size) {
    state_size_ = static_cast<std::size_t>(state_size);
    capacity_ = legs;
    legs_ = arena.allocate<Leg>(Pool::improvement, legs);
    states_ = arena.allocate<float>(Pool::improvement, legs / kLegsAState + 1, static_cast<std::uint32_t>(state_size));
  }

  void clear() {
    count_ = 0;
    steps_ = 0;
  }
  std::uint32_t count() const { return count_; }
  std::uint32_t capacity() const { return capacity_; }
  bool full() const { return count_ == capacity_; }
  std::uint32_t steps() const { return steps_; }  // of all legs
  const Leg& operator[](std::uint32_t i) const {
    KRAIT_ASSERT(i < count_);
    return legs_[i];
  }

  // Begins a leg, of no steps yet, from `state`. Not when full.
  void add(const PackedTarget& target, float arc, const float* state) {
    KRAIT_ASSERT(!full());
    if (count_ % kLegsAState == 0) {
      for (std::size_t i = 0; i < state_size_; ++i) states_[count_ / kLegsAState * state_size_ + i] = state[i];
    }
    legs_[count_++] = {target, 0, arc};
  }
  // A whole leg, of a way whose states are not needed. Not when full.
  void add(const PackedTarget& target, std::uint32_t steps) {
    KRAIT_ASSERT(!full());
    legs_[count_++] = {target, steps, 0.0F};
    steps_ += steps;
  }
  // Counts a step of the last leg.
  void step() {
    KRAIT_ASSERT(count_ > 0);
    ++legs_[count_ - 1].steps;
    ++steps_;
  }

  void remove_last() {
    KRAIT_ASSERT(count_ > 0);
    steps_ -= legs_[--count_].steps;
  }

  // The state that leg i begins from, for i a multiple of kLegsAState.
  const float* state(std::uint32_t i) const {
    KRAIT_ASSERT(i % kLegsAState == 0 && i < count_);
    return states_ + i / kLegsAState * state_size_;
  }

  // Becomes the first `legs` legs of another way of the same capacity. O(legs).
  void copy(const Way& from, std::uint32_t legs) {
    KRAIT_ASSERT(legs <= from.count_ && legs <= capacity_);
    clear();
    for (std::uint32_t i = 0; i < legs; ++i) {
      legs_[i] = from.legs_[i];
      steps_ += legs_[i].steps;
    }
    const std::size_t floats = (legs + kLegsAState - 1) / kLegsAState * state_size_;
    for (std::size_t i = 0; i < floats; ++i) states_[i] = from.states_[i];
    count_ = legs;
  }

 private:
  Leg* legs_ = nullptr;
  float* states_ = nullptr;
  std::size_t state_size_ = 0;
  std::uint32_t capacity_ = 0;
  std::uint32_t count_ = 0;
  std::uint32_t steps_ = 0;
};

}  // namespace krait::detail
