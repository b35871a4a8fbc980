// SPDX-License-Identifier: Apache-2.0
#include "krait/robot_check.hpp"

#include <cmath>
#include <map>
#include <optional>

#include "krait/status.hpp"
#include "robot/shape.hpp"
#include "robot_check/answers.hpp"
#include "robot_check/bounds.hpp"
#include "robot_check/control.hpp"
#include "robot_check/invariance.hpp"
#include "robot_check/ranges.hpp"
#include "robot_check/samples.hpp"
#include "robot_check/speeds.hpp"
#include "robot_check/steps.hpp"

namespace krait {
namespace detail::checking {
namespace {

bool frames_are_finite(const Case& c) {
  for (const auto& at : c.frames) {
    for (const Frame& frame : at) {
      if (!(std::isfinite(frame.x + frame.y) && std::isfinite(frame.sin + frame.cos))) return false;
    }
  }
  return true;
}

class RobotCheck {
 public:
  RobotCheck(const Robot& robot, const RobotRanges& ranges, std::uint64_t seed, RobotReport& report)
      : robot_(robot), ranges_(ranges), findings_(report), draws_(ranges, seed) {}

  void run(int samples) {
    if (!usable()) return;
    if (samples < 1) findings_.add("ranges", "samples", "no sample was asked for, so that nothing was checked.");
    for (int i = 0; i < samples; ++i) {
      findings_.begin_sample();
      const std::optional<Case> drawn = draw();
      if (!drawn) return;
      check(*drawn);
    }
    check_leaving(findings_, ranges_, steered_);
    check_driven(driven_, findings_);
  }

 private:
  // Whether the robot's sizes and shapes and the ranges can be used at all.
  bool usable() {
    const Argument bad = first_bad_of_robot(robot_);
    if (bad != Argument::none) {
      findings_.add("body", to_string(bad),
                    "init refuses the robot: " + std::string(to_string(bad)) +
                        ". robot_dimensions: sound() is false, or in C a function that it needs is NULL; robot_sizes: "
                        "a size is beyond its maximum; robot_polygon: a body "
                        "has not 3 to 8 vertices, convex and counter-clockwise.");
      return false;
    }
    if (!robot_.exact()) {
      findings_.add(
          "exact", "arithmetic",
          "init refuses the robot: its file was not compiled with -ffp-contract=off, or with other flags that "
          "change what floats compute.");
      return false;
    }
    return check_ranges(robot_, ranges_, findings_);
  }

  // Returns a state within the limits, or an empty one where none of many draws is.
  std::vector<float> state_within_limits() {
    constexpr int kTries = 10'000;
    for (int i = 0; i < kTries; ++i) {
      std::vector<float> state = draws_.state();
      if (robot_.within_limits(state.data())) return state;
    }
    findings_.add("within_limits", "ranges",
                  "of " + std::to_string(kTries) +
                      " states that were drawn from the ranges none is within the limits: narrow the ranges of the "
                      "state, or set `complete_state`.");
    return {};
  }

  std::optional<Case> draw() {
    Case drawn{robot_, ranges_, findings_, {state_within_limits(), draws_.control(), draws_.dt()}, {}, {}, {}, {}};
    if (drawn.sample.state.empty()) return std::nullopt;
    drawn.other = state_within_limits();
    if (drawn.other.empty()) return std::nullopt;
    return drawn;
  }

  // Draws controls until one ends the step within the limits, as every step does that travel bounds. False, and the
  // motion is unknown, when none does.
  bool move(Case& c) {
    for (int i = 0; i < kControlsTried; ++i) {
      c.motion = fine_motion(robot_, c.sample, static_cast<double>(c.sample.dt));
      c.next = rounded(c.motion.end());
      if (robot_.within_limits(c.next.data())) return true;
      c.sample.control = draws_.control();
    }
    c.next.clear();
    return false;
  }

  void check(Case c) {
    check_within_limits(c);
    check_bodies(c);
    const bool rates = check_derivative(c);
    const bool places = check_place(c);
    if (!rates || !places) return;
    const Vec2 position{c.sample.state[0], c.sample.state[1]};
    const Target target = draws_.target(position, robot_.reversible(), c.sample.dt);
    check_steer(c, target, 10, steered_);
    check_braking(c, target);
    check_leading(c);
    check_integration(c);
    check_fastest_rate(c);
    check_speeds(c);
    check_motion(c);
  }

  void check_motion(Case& c) {
    constexpr double kAlmostPi = 3.1;
    const double angle = static_cast<double>(draws_.even({-1.0F, 1.0F})) * kAlmostPi;
    DrivenSamples& driven = driven_[c.sample.dt];
    ++driven.all;
    if (!move(c)) return;
    ++driven.checked;
    if (!c.motion.resolved) {
      c.fault("derivative", "smooth", kInfinite, "2,048 Runge-Kutta steps do not tell where it leads",
              "It must be continuous, and not too fast for the time step.");
      return;
    }
    for (const Numbers& state : c.motion.states) c.frames.push_back(frames_of(robot_, rounded(state)));
    if (!frames_are_finite(c)) {
      c.fault("place", "finite", kInfinite, "a frame on the way is not finite", "Every frame must be finite.");
      return;
    }
    check_travel(c);
    check_quick_bound(c);
    check_place_follows(c);
    check_invariance(c, angle);
  }

  const Robot& robot_;
  const RobotRanges& ranges_;
  Findings findings_;
  Draws draws_;
  SteeredSteps steered_;
  std::map<float, DrivenSamples> driven_;  // by time step
};

}  // namespace
}  // namespace detail::checking

RobotReport check_robot(const Robot& robot, const RobotRanges& ranges, int samples, std::uint64_t seed) {
  RobotReport report;
  detail::checking::RobotCheck(robot, ranges, seed, report).run(samples);
  return report;
}

}  // namespace krait
