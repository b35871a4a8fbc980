// SPDX-License-Identifier: Apache-2.0
// Whether what a robot offers beside derivative agrees with it: its leading components, its own integration, and how
// fast it says to be. For hosts.
#pragma once

#include "krait/robot_check/answers.hpp"

namespace krait::checking {

// Behind a state of fewer components stands none.
inline std::vector<float> leading(const std::vector<float>& state, int count) {
  std::vector<float> part(state.begin(), state.begin() + count);
  part.reserve(state.size());
  return part;
}

template <RobotModel R>
bool check_leading_size(const Case<R>& c) {
  const int size = leading_size(c.robot);
  if (size >= 2 && size <= c.robot.state_size()) return true;
  c.fault("leading_size", "range", kInfinite, "leading_size is " + std::to_string(size),
          "It must be at least 2, for the position, and at most state_size().");
  return false;
}

template <RobotModel R>
void check_leading(const Case<R>& c) {
  if (!check_leading_size(c) || leading_size(c.robot) == c.robot.state_size()) return;
  const int size = leading_size(c.robot);
  const std::vector<float> front = leading(c.sample.state, size);
  const std::vector<float> whole = derivative_of(c.robot, c.sample.state, c.sample.control);
  const std::vector<float> rates = derivative_of(c.robot, front, c.sample.control);
  if (!same_bits(rates, leading(whole, size))) {
    c.fault("leading_size", "derivative", kInfinite,
            "of the leading components alone derivative answers " + list(rates) + ", of the whole state " +
                list(leading(whole, size)),
            "The first leading_size() rates must depend on no other component, to the bit.");
  }
  std::vector<Pose> poses(static_cast<std::size_t>(c.robot.body_count()), Pose{{kFills[0], 0}, {0, 0}});
  c.robot.place(view(front), poses.data());
  const bool same = same_bits(numbers_of(std::vector<Pose>{poses[0]}),
                              numbers_of(std::vector<Pose>{poses_of(c.robot, c.sample.state)[0]}));
  bool others = false;
  for (std::size_t k = 1; k < poses.size(); ++k) others = others || poses[k].position.x != kFills[0];
  if (!same || others) {
    c.fault("leading_size", "place", kInfinite,
            same ? "of the leading components alone place writes other bodies than body 0"
                 : "of the leading components alone place puts body 0 elsewhere",
            "place must take a state of leading_size() components, and write body 0 only, as of the whole state.");
  }
}

// What integrate_lead and integrate_rest add to a state.
template <LeadingRobot R>
std::vector<float> increments(const R& robot, const Sample& sample, float fill) {
  const std::vector<Pose> poses = poses_of(robot, sample.state);
  std::vector<float> d(sample.state.size(), fill);
  typename R::Lead lead;
  robot.integrate_lead(view(sample.state), poses.data(), view(sample.control), sample.dt, lead, d.data());
  robot.integrate_rest(view(sample.state), poses.data(), sample.dt, lead, d.data());
  return d;
}

template <LeadingRobot R>
void check_increments(const Case<R>& c) {
  const std::vector<float> d = increments(c.robot, c.sample, kFills[0]);
  const Numbers from(c.sample.state.begin(), c.sample.state.end());
  const Numbers to = runge_kutta_step(c.robot, from, c.sample.control, static_cast<double>(c.sample.dt));
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double expected = to[i] - from[i];
    const double off = std::abs(static_cast<double>(d[i]) - expected);
    if (off <= 1e-5 * (1 + std::abs(expected))) continue;
    const bool lead = i < static_cast<std::size_t>(c.robot.leading_size());
    c.fault(lead ? "integrate_lead" : "integrate_rest", "step", off,
            "it adds " + number(static_cast<double>(d[i]), 9) + " to component " + std::to_string(i) +
                ", where a Runge-Kutta step of derivative adds " + number(expected, 9),
            "It must add what the classical Runge-Kutta step of derivative does, but for rounding.");
  }
}

template <LeadingRobot R>
void check_lead_alone(const Case<R>& c) {
  const int size = c.robot.leading_size();
  const std::vector<float> whole = increments(c.robot, c.sample, 0.0F);
  const std::vector<float> front = leading(c.sample.state, size);
  std::vector<Pose> poses(static_cast<std::size_t>(c.robot.body_count()));
  c.robot.place(view(front), poses.data());
  std::vector<float> d(front.size());
  typename R::Lead lead;
  c.robot.integrate_lead(view(front), poses.data(), view(c.sample.control), c.sample.dt, lead, d.data());
  if (same_bits(d, leading(whole, size))) return;
  c.fault("integrate_lead", "leading", kInfinite,
          "of the leading components alone it adds " + list(d) + ", of the whole state " + list(leading(whole, size)),
          "It must take a state of leading_size() components, and add the same to the bit.");
}

template <RobotModel R>
void check_integration(const Case<R>& c) {
  if constexpr (LeadingRobot<R>) {
    if (!check_leading_size(c)) return;
    check_repeats(c, "integrate_rest", [&](const std::vector<float>& state, float fill) {
      return increments(c.robot, {state, c.sample.control, c.sample.dt}, fill);
    });
    check_increments(c);
    check_lead_alone(c);
  }
}

// A step as long as the library makes them of a robot that says how fast it is.
template <RobotModel R>
void check_fastest_rate(const Case<R>& c) {
  if constexpr (requires {
                  { c.robot.fastest_rate(c.sample.dt) } -> std::same_as<float>;
                }) {
    check_repeats(c, "fastest_rate", [&](const std::vector<float>&, float) {
      return std::vector<float>{c.robot.fastest_rate(c.sample.dt)};
    });
    const float rate = c.robot.fastest_rate(c.sample.dt);
    if (!(rate >= 0) || !finite(rate)) {
      c.fault("fastest_rate", "number", kInfinite, "fastest_rate is " + number(static_cast<double>(rate)) + " 1/s",
              "It must be finite and not negative.");
      return;
    }
    const float longest = c.ranges.step_rate / rate;
    if (!(longest > 0)) return;
    Sample step = c.sample;
    step.dt = longest < step.dt ? longest : step.dt;
    const auto dt = static_cast<double>(step.dt);
    const Numbers coarse = runge_kutta_step(c.robot, Numbers(step.state.begin(), step.state.end()), step.control, dt);
    const double off = difference(coarse, fine_motion(c.robot, step, dt).end());
    if (off <= static_cast<double>(c.ranges.step_error)) return;
    c.findings.add(
        "fastest_rate", "step", off,
        "at " + number(static_cast<double>(rate)) + " 1/s a Runge-Kutta step of " + number(dt) + " s ends " +
            number(off) + " (metres or radians) from where derivative leads",
        step,
        "Raise fastest_rate: it must be no less than the fastest rate, in 1/s, at which an angle of the dynamics "
        "changes within the limits.");
  }
}

}  // namespace krait::checking
