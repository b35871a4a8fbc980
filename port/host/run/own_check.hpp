// SPDX-License-Identifier: Apache-2.0
// A collision check beside a planner's, with the memory that it needs.
#pragma once

#include <cstdint>
#include <vector>

#include "base/arena.hpp"
#include "collision/motion_check.hpp"
#include "krait/parameters.hpp"

namespace krait::host {

// Of the robot in the scene, which must both outlive it, with whole steps proven.
class OwnCheck : public detail::MotionCheck {
 public:
  OwnCheck(const Robot& robot, const krait::Scene& scene, const Parameters& parameters) {
    detail::Arena counting;
    allocate(counting, robot);
    block_.resize((counting.needed() + 7) / 8);
    detail::Arena arena(block_.data(), counting.needed());
    allocate(arena, robot);
    assign(robot, scene, parameters.clearance, static_cast<int>(parameters.tuning.max_substeps), true);
  }
  OwnCheck(const OwnCheck&) = delete;
  OwnCheck& operator=(const OwnCheck&) = delete;

 private:
  std::vector<std::uint64_t> block_;
};

}  // namespace krait::host
