// SPDX-License-Identifier: Apache-2.0
// The last states of an expansion, which are kept to grow from some steps later, if it has not collided by then.
#pragma once

#include "base/arena.hpp"
#include "krait/geometry.hpp"
#include "krait/parameters.hpp"
#include "krait/robot.hpp"

namespace krait::detail {

class RecentStates {
 public:
  // 16 bytes a component of the state.
  void allocate(Arena& arena, const Robot& robot) {
    size_ = robot.state_size();
    states_ = arena.allocate<float>(Pool::work, kCount, static_cast<std::uint32_t>(size_));
  }

  // Keeps the state after `step` steps, and its region.
  void remember(std::uint32_t step, Index region, const float* state) {
    regions_[step % kCount] = region;
    float* const copy = states_ + place(step);
    for (int i = 0; i < size_; ++i) copy[i] = state[i];
  }

  // What was remembered of one of the last kCount steps.
  Index region(std::uint32_t step) const { return regions_[step % kCount]; }
  const float* state(std::uint32_t step) const { return states_ + place(step); }

 private:
  static constexpr std::uint32_t kCount = SearchTuning::kMostDoomedSteps + 1;

  std::size_t place(std::uint32_t step) const {
    return static_cast<std::size_t>(step % kCount) * static_cast<std::size_t>(size_);
  }

  int size_ = 0;
  float* states_ = nullptr;  // of step s at place s % kCount, and
  Index regions_[kCount]{};  // their regions
};

}  // namespace krait::detail
