// SPDX-License-Identifier: Apache-2.0
// Holds a robot of one's own to what the RobotModel concept asks of it (krait/robot/robot_model.hpp), before it plans:
// against its own derivative, integrated finely in double precision. For hosts: not part of krait.hpp, with the
// standard library.
#pragma once

#include <optional>

#include "krait/robot/shape.hpp"
#include "krait/robot_check/bounds.hpp"
#include "krait/robot_check/control.hpp"
#include "krait/robot_check/invariance.hpp"
#include "krait/robot_check/steps.hpp"

namespace krait {
namespace checking {

template <RobotModel R>
class RobotCheck {
 public:
  RobotCheck(const R& robot, const RobotRanges& ranges, std::uint64_t seed, RobotReport& report)
      : robot_(robot), ranges_(ranges), findings_(report), draws_(ranges, seed) {}

  void run(int samples) {
    if (!usable()) return;
    for (int i = 0; i < samples; ++i) {
      findings_.begin_sample();
      const std::optional<Case<R>> drawn = draw();
      if (!drawn) return;
      check(*drawn);
    }
    check_leaving(findings_, ranges_, steered_);
  }

 private:
  // Whether the robot's sizes and shapes and the ranges can be used at all.
  bool usable() {
    const Argument bad = first_bad_of_robot(robot_);
    if (bad != Argument::none) {
      findings_.add(
          "body", name(bad),
          "init refuses the robot: " + std::string(name(bad)) +
              ". robot_dimensions: sound() is false; robot_sizes: a size is beyond its maximum; robot_polygon: a body "
              "has not 3 to 8 vertices, convex and counter-clockwise.");
      return false;
    }
    const bool fit = ranges_.state.size() == static_cast<std::size_t>(robot_.state_size()) &&
                     ranges_.control.size() == static_cast<std::size_t>(robot_.control_size()) && !ranges_.dt.empty();
    if (!fit) {
      findings_.add("ranges", "sizes",
                    "RobotRanges has " + std::to_string(ranges_.state.size()) + " ranges of states, " +
                        std::to_string(ranges_.control.size()) + " of controls and " +
                        std::to_string(ranges_.dt.size()) + " time steps; the robot has " +
                        std::to_string(robot_.state_size()) + " and " + std::to_string(robot_.control_size()) +
                        ", and one time step is needed.");
    }
    return fit;
  }

  // A state within the limits; empty after many in vain.
  std::vector<float> state_within_limits() {
    constexpr int kTries = 10'000;
    for (int i = 0; i < kTries; ++i) {
      std::vector<float> state = draws_.state();
      if (robot_.within_limits(view(state))) return state;
    }
    findings_.add("within_limits", "ranges",
                  "of " + std::to_string(kTries) +
                      " states that were drawn from the ranges none is "
                      "within the limits: narrow RobotRanges::state, or give RobotRanges::arrange.");
    return {};
  }

  std::optional<Case<R>> draw() {
    Case<R> drawn{robot_, ranges_, findings_, {state_within_limits(), draws_.control(), draws_.dt()}, {}, {}, {}, {}};
    if (drawn.sample.state.empty()) return std::nullopt;
    drawn.other = state_within_limits();
    if (drawn.other.empty()) return std::nullopt;
    return drawn;
  }

  // Draws controls until one ends the step within the limits, which is all that travel is asked about. False, and the
  // motion is unknown, when none does.
  bool move(Case<R>& c) {
    constexpr int kTries = 20;
    for (int i = 0; i < kTries; ++i) {
      c.motion = fine_motion(robot_, c.sample, static_cast<double>(c.sample.dt));
      c.next = rounded(c.motion.end());
      if (robot_.within_limits(view(c.next))) return true;
      c.sample.control = draws_.control();
    }
    c.next.clear();
    return false;
  }

  bool frames_are_finite(const Case<R>& c) const {
    for (const auto& at : c.frames) {
      for (const Frame& frame : at) {
        if (!(std::isfinite(frame.x + frame.y) && std::isfinite(frame.sin + frame.cos))) return false;
      }
    }
    return true;
  }

  void check(Case<R> c) {
    check_within_limits(c);
    check_bodies(c);
    const bool rates = check_derivative(c);
    const bool places = check_place(c);
    if (!rates || !places) return;
    const Target target = draws_.target(position(view(c.sample.state)), reversible(robot_), c.sample.dt);
    check_steer(c, target, 10, steered_);
    check_leading(c);
    check_integration(c);
    check_fastest_rate(c);
    check_motion(c);
  }

  void check_motion(Case<R>& c) {
    constexpr double kAlmostPi = 3.1;
    const double angle = static_cast<double>(draws_.even({-1.0F, 1.0F})) * kAlmostPi;
    if (!move(c)) return;
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

  const R& robot_;
  const RobotRanges& ranges_;
  Findings findings_;
  Draws draws_;
  SteeredSteps steered_;
};

}  // namespace checking

// Draws so many states and controls from the ranges and names every promise of the concept that the robot breaks at
// one, in the worst case found. The same for the same seed. What it does not find is not proven: samples are no proof.
// Work: some thousand derivatives a sample.
template <RobotModel R>
RobotReport check_robot(const R& robot, const RobotRanges& ranges, int samples = 1000, std::uint64_t seed = 1) {
  RobotReport report;
  checking::RobotCheck<R>(robot, ranges, seed, report).run(samples);
  return report;
}

}  // namespace krait
