// SPDX-License-Identifier: Apache-2.0
#include "robot_check/steps.hpp"

#include <algorithm>
#include <cmath>

#include "robot_check/answers.hpp"

namespace krait::detail::checking {
namespace {

// Behind a state of fewer components stands none.
std::vector<float> leading(const std::vector<float>& state, int count) {
  std::vector<float> part(state.begin(), state.begin() + count);
  part.reserve(state.size());
  return part;
}

bool check_leading_size(const Case& c) {
  const int size = c.robot.leading_size();
  if (size >= 2 && size <= c.robot.state_size()) return true;
  c.fault("leading_size", "range", kInfinite, "leading_size is " + std::to_string(size),
          "It must be at least 2, for the position, and at most state_size().");
  return false;
}

// What integrate_lead and integrate_rest add to a state.
std::vector<float> increments(const Robot& robot, const Sample& sample, float fill) {
  const std::vector<Pose> poses = poses_of(robot, sample.state);
  std::vector<float> d(sample.state.size(), fill);
  Lead lead;
  robot.integrate_lead(sample.state.data(), poses.data(), sample.control.data(), sample.dt, lead, d.data());
  robot.integrate_rest(sample.state.data(), poses.data(), sample.dt, lead, d.data());
  return d;
}

void check_increments(const Case& c) {
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

void check_lead_alone(const Case& c) {
  const int size = c.robot.leading_size();
  const std::vector<float> whole = increments(c.robot, c.sample, 0.0F);
  const std::vector<float> front = leading(c.sample.state, size);
  std::vector<Pose> poses(static_cast<std::size_t>(c.robot.body_count()));
  c.robot.place_lead(front.data(), poses.data());
  std::vector<float> d(front.size());
  Lead lead;
  c.robot.integrate_lead_alone(front.data(), poses.data(), c.sample.control.data(), c.sample.dt, lead, d.data());
  if (same_bits(d, leading(whole, size))) return;
  c.fault("integrate_lead", "leading", kInfinite,
          "of the leading components alone it adds " + list(d) + ", of the whole state " + list(leading(whole, size)),
          "It must take a state of leading_size() components, and add the same to the bit.");
}

// Whether a Runge-Kutta step of dt seconds, as long as such a rate allows, ends where derivative leads.
void check_step(const Case& c, float rate, float dt) {
  const Sample step{c.sample.state, c.sample.control, dt};
  const auto time = static_cast<double>(dt);
  const Numbers coarse = runge_kutta_step(c.robot, Numbers(step.state.begin(), step.state.end()), step.control, time);
  const double off = difference(coarse, fine_motion(c.robot, step, time).end());
  if (off <= static_cast<double>(c.ranges.step_error)) return;
  c.findings.add(
      "fastest_rate", "step", off,
      "at " + number(static_cast<double>(rate)) + " 1/s a Runge-Kutta step of " + number(time) + " s ends " +
          number(off) + " (metres or radians) from where derivative leads",
      step,
      "Raise fastest_rate: it must be no less than the fastest rate, in 1/s, at which an angle of the dynamics "
      "changes within the limits.");
}

}  // namespace

void check_leading(const Case& c) {
  const int size = c.robot.leading_size();
  if (!check_leading_size(c) || size == c.robot.state_size()) return;
  const std::vector<float> front = leading(c.sample.state, size);
  const std::vector<float> whole = derivative_of(c.robot, c.sample.state, c.sample.control);
  std::vector<float> rates(front.size());
  c.robot.lead_rates(front.data(), c.sample.control.data(), rates.data());
  if (!same_bits(rates, leading(whole, size))) {
    c.fault("leading_size", "derivative", kInfinite,
            "of the leading components alone derivative returns " + list(rates) + ", of the whole state " +
                list(leading(whole, size)),
            "The first leading_size() rates must depend on no other component, to the bit.");
  }
  std::vector<Pose> poses(static_cast<std::size_t>(c.robot.body_count()), Pose{{kFills[0], 0}, {0, 0}});
  c.robot.place_lead(front.data(), poses.data());
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

void check_integration(const Case& c) {
  if (!c.robot.leads() || !check_leading_size(c)) return;
  check_repeats(c, "integrate_rest", [&](const std::vector<float>& state, float fill) {
    return increments(c.robot, {state, c.sample.control, c.sample.dt}, fill);
  });
  check_increments(c);
  check_lead_alone(c);
}

void check_fastest_rate(const Case& c) {
  check_repeats(c, "fastest_rate", [&](const std::vector<float>&, float) {
    return std::vector<float>{c.robot.fastest_rate(c.sample.dt)};
  });
  const float rate = c.robot.fastest_rate(c.sample.dt);
  const bool holds = rate >= 0 && finite(rate);
  if (!check_number(c, "fastest_rate", holds, rate, "1/s", "It must be finite and not negative.")) return;
  const float longest = c.ranges.step_rate / rate;  // infinite for a robot that does not say
  if (!(longest > 0) || !finite(longest)) return;
  check_step(c, rate, std::min(c.sample.dt, longest));
}

}  // namespace krait::detail::checking
