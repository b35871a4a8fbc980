// SPDX-License-Identifier: Apache-2.0
#include "robot_check/speeds.hpp"

#include "robot_check/answers.hpp"

namespace krait::detail::checking {
namespace {

void hold(const Case& c, const char* function, bool holds, float value, const char* unit, const char* rule) {
  if (holds) return;
  c.fault(function, "number", kInfinite,
          std::string(function) + " is " + number(static_cast<double>(value)) + " " + unit, rule);
}

}  // namespace

void check_speeds(const Case& c) {
  constexpr float kLength = 1.0F;  // metres of body 0, from which the library derives what a robot does not say
  check_repeats(c, "speed", [&](const std::vector<float>& state, float) {
    return std::vector<float>{c.robot.speed(state.data()), c.robot.stopping_way(state.data())};
  });
  const float speed = c.robot.speed(c.sample.state.data());
  const float way = c.robot.stopping_way(c.sample.state.data());
  const float radius = c.robot.turning_radius(kLength);
  const float top = c.robot.top_speed(kLength);
  hold(c, "speed", speed >= 0 && finite(speed), speed, "m/s", "It must be finite and not negative.");
  hold(c, "stopping_way", finite(way), way, "m", "It must be finite.");
  hold(c, "turning_radius", radius >= 0, radius, "m", "It must not be NaN or negative.");
  hold(c, "top_speed", top > 0 && finite(top), top, "m/s", "It must be finite and above 0.");
}

}  // namespace krait::detail::checking
