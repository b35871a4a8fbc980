// SPDX-License-Identifier: Apache-2.0
#include "robot_check/case.hpp"

#include <cmath>

namespace krait::detail::checking {

bool nearly_within_limits(const Robot& robot, const std::vector<float>& state) {
  if (robot.within_limits(state.data())) return true;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const float little = 1e-5F * (1.0F + std::abs(state[i]));
    for (const float by : {-little, little}) {
      std::vector<float> beside = state;
      beside[i] += by;
      if (robot.within_limits(beside.data())) return true;
    }
  }
  return false;
}

int beyond_limits(const Robot& robot, const Motion33& motion) {
  for (int i = Motion33::kParts; i >= 0; --i) {
    if (!nearly_within_limits(robot, rounded(motion.states[static_cast<std::size_t>(i)]))) return i;
  }
  return -1;
}

}  // namespace krait::detail::checking
