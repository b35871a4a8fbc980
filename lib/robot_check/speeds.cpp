// SPDX-License-Identifier: Apache-2.0
#include "robot_check/speeds.hpp"

#include "robot_check/answers.hpp"

namespace krait::detail::checking {
void check_speeds(const Case& c) {
  constexpr float kLength = 1.0F;  // metres of body 0, from which the library derives what a robot does not say
  check_repeats(c, "speed", [&](const std::vector<float>& state, float) {
    return std::vector<float>{c.robot.speed(state.data()), c.robot.stopping_way(state.data())};
  });
  const float speed = c.robot.speed(c.sample.state.data());
  const float way = c.robot.stopping_way(c.sample.state.data());
  const float radius = c.robot.turning_radius(kLength);
  const float top = c.robot.top_speed(kLength);
  check_number(c, "speed", speed >= 0 && finite(speed), speed, "m/s", "It must be finite and not negative.");
  check_number(c, "stopping_way", finite(way), way, "m", "It must be finite.");
  check_number(c, "turning_radius", radius >= 0, radius, "m", "It must not be NaN or negative.");
  check_number(c, "top_speed", top > 0 && finite(top), top, "m/s", "It must be finite and above 0.");
}

}  // namespace krait::detail::checking
