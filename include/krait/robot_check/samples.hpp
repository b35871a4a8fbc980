// SPDX-License-Identifier: Apache-2.0
// Draws states and controls of a robot from ranges. For hosts.
#pragma once

#include <functional>
#include <vector>

#include "krait/base/random.hpp"
#include "krait/motion/rk4.hpp"
#include "krait/robot/robot.hpp"
#include "krait/robot_check/report.hpp"

namespace krait {

struct RobotRange {
  float low;
  float high;
};

// Where a robot's states and controls lie, in its own units, and what holds of it.
struct RobotRanges {
  std::vector<RobotRange> state;    // one a component; drawn evenly, but for the position now and then at the ends
  std::vector<RobotRange> control;  // one a component: the limits that steer keeps to; drawn likewise
  std::vector<float> dt = {0.1F};   // seconds: the time steps to be tried
  // The components of the state that are headings, in radians: turning the robot adds to them and changes nothing else
  // but the position. Whether it moves alike in every direction is checked where there are any.
  std::vector<int> headings = {};
  bool anywhere = true;  // whether it moves alike wherever it stands, which is checked then
  float leaving = 0.0F;  // 0 … 1: share of steered steps that may leave the limits, as where hitches fold
  // A Runge-Kutta step of step_rate / fastest_rate(dt) seconds, and at most dt, is to be accurate to step_error, in
  // metres and radians: as the library makes them while the tree grows (lib/DESIGN.md, "Integration"). 0: not checked.
  float step_rate = kStepRate;
  float step_error = 5e-4F;
  // Makes a state of the numbers that were drawn, where components depend on each other; none: they are the state.
  std::function<void(std::vector<float>& state)> arrange = {};
};

namespace checking {

inline StateView view(const std::vector<float>& s) { return {s.data(), static_cast<Eigen::Index>(s.size())}; }
inline StateRef writable(std::vector<float>& s) { return {s.data(), static_cast<Eigen::Index>(s.size())}; }

class Draws {
 public:
  Draws(const RobotRanges& ranges, std::uint64_t seed) : ranges_(ranges), random_(seed) {}

  // Not necessarily within the limits.
  std::vector<float> state() {
    std::vector<float> drawn;
    for (const RobotRange& range : ranges_.state) drawn.push_back(drawn.size() < 2 ? even(range) : with_ends(range));
    if (ranges_.arrange) ranges_.arrange(drawn);
    return drawn;
  }

  std::vector<float> control() {
    std::vector<float> drawn;
    for (const RobotRange& range : ranges_.control) drawn.push_back(with_ends(range));
    return drawn;
  }

  float dt() { return ranges_.dt[random_.below(static_cast<std::uint32_t>(ranges_.dt.size()))]; }

  // A target around the position; the position itself now and then.
  Target target(Vec2 position, bool reversible, float dt) {
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

  float even(const RobotRange& range) { return range.low + (range.high - range.low) * random_.unit(); }

 private:
  float with_ends(const RobotRange& range) {
    const std::uint32_t kind = random_.below(8);
    return kind == 0 ? range.low : kind == 1 ? range.high : even(range);
  }

  const RobotRanges& ranges_;
  Random random_;
};

}  // namespace checking
}  // namespace krait
