// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "hoverer.hpp"
#include "krait/robot_check.hpp"

// A robot that jumps further than it says.
struct Leaper : Hoverer {
  bool travel(krait::StateView s, krait::ControlView u, float dt, krait::StateView next, krait::Travel* travel) const {
    const bool limits_hold = Hoverer::travel(s, u, dt, next, travel);
    travel[0].path = 0.5F * travel[0].path;
    return limits_hold;
  }
};

int main() {
  const krait::RobotRanges ranges{.state = {{-9, 9}, {-9, 9}, {-1, 1}, {-1, 1}}, .control = {{-2, 2}, {-2, 2}}};
  const Hoverer hoverer;
  const Leaper leaper;
  const krait::RobotReport sound = krait::check_robot(hoverer, ranges);
  const krait::RobotReport unsound = krait::check_robot(leaper, ranges);
  std::printf("%s%s", sound.text().c_str(), unsound.text().c_str());
  return sound.ok() && !unsound.ok() ? 0 : 1;
}
