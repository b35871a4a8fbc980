// SPDX-License-Identifier: Apache-2.0
// What works in arrays of the robot's sizes, in memory of its own.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/arena.hpp"
#include "krait/robot.hpp"

namespace krait::test {

// Tool is MotionCheck or Sketcher.
template <class Tool>
class InOwnMemory : public Tool {
 public:
  InOwnMemory() = default;
  InOwnMemory(InOwnMemory&&) = default;
  InOwnMemory(const InOwnMemory&) = delete;  // would share the memory

  template <class... Arguments>
  void assign(const Robot& robot, Arguments&&... arguments) {
    detail::Arena counting;
    Tool::allocate(counting, robot);
    block_.assign(counting.needed() / sizeof(std::uint64_t), 0);
    detail::Arena arena(block_.data(), counting.needed());
    Tool::allocate(arena, robot);
    Tool::assign(robot, std::forward<Arguments>(arguments)...);
  }

 private:
  std::vector<std::uint64_t> block_;
};

}  // namespace krait::test
