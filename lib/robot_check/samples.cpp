// SPDX-License-Identifier: Apache-2.0
#include "robot_check/samples.hpp"

namespace krait::detail::checking {

std::vector<float> Draws::state() {
  std::vector<float> drawn;
  for (const RobotRange& range : ranges_.state) drawn.push_back(drawn.size() < 2 ? even(range) : with_ends(range));
  if (ranges_.complete_state) ranges_.complete_state(drawn);
  return drawn;
}

std::vector<float> Draws::control() {
  std::vector<float> drawn;
  for (const RobotRange& range : ranges_.control) drawn.push_back(with_ends(range));
  return drawn;
}

Target Draws::target(Vec2 position, bool reversible, float dt) {
  constexpr RobotRange kAround{-20.0F, 20.0F};
  Target target;
  target.point = position;
  if (random_.below(16) != 0) target.point = position + Vec2{even(kAround), even(kAround)};
  target.speed = even({0.05F, 1.0F});
  if (reversible && random_.below(2) == 0) target.speed = -target.speed;
  target.turn = random_.below(2) == 0 ? 1.0F : even({0.15F, 1.0F});
  target.dt = dt;
  return target;
}

float Draws::with_ends(const RobotRange& range) {
  const std::uint32_t kind = random_.below(8);
  return kind == 0 ? range.low : kind == 1 ? range.high : even(range);
}

}  // namespace krait::detail::checking
