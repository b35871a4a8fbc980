// SPDX-License-Identifier: Apache-2.0
// Draws states and controls of a robot from ranges.
#pragma once

#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "krait/robot_check.hpp"

namespace krait::detail::checking {

class Draws {
 public:
  Draws(const RobotRanges& ranges, std::uint64_t seed) : ranges_(ranges), random_(seed) {}

  // Not necessarily within the limits.
  std::vector<float> state();
  std::vector<float> control();
  float dt() { return ranges_.dt[random_.below(static_cast<std::uint32_t>(ranges_.dt.size()))]; }

  // A target around the position; the position itself now and then.
  Target target(Vec2 position, bool reversible, float dt);

  float even(const RobotRange& range) { return range.low + (range.high - range.low) * random_.unit(); }

 private:
  float with_ends(const RobotRange& range);

  const RobotRanges& ranges_;
  Random random_;
};

}  // namespace krait::detail::checking
