// SPDX-License-Identifier: Apache-2.0
// When a search restarts. Most searches end soon, some very late, and one that has run long for its kind is better
// begun again: by Knuth's reluctant doubling its tries last 1, 1, 2, 1, 1, 2, 4, 1, … units, which is within a
// logarithmic factor of the best that could be known (Luby, Sinclair and Zuckerman 1993).
#pragma once

#include <cstdint>

#include "krait/math.hpp"

namespace krait::detail {

class Restarts {
 public:
  // Units are of `share` times `unit` expansions, one at least; 0: the first try lasts for ever.
  void begin(std::uint32_t unit, float share) {
    const float scaled = math::clamp(share * static_cast<float>(unit), 1.0F, kMostUnit);
    unit_ = unit == 0 ? 0 : static_cast<std::uint32_t>(scaled);
    turn_ = 1;
    units_ = 1;
    remaining_ = unit_;
  }

  // Lets the next expansion begin the next try, if there are tries.
  void end_try() { remaining_ = 0; }

  // The last expansion is not to be counted.
  void uncount() { remaining_ += unit_ != 0 ? 1 : 0; }

  // Counts an expansion; whether the try was over before it, so that the next one begins.
  bool due() {
    if (unit_ == 0) return false;
    if (remaining_ > 0) {
      --remaining_;
      return false;
    }
    next_term();
    remaining_ = std::uint64_t{unit_} * units_ - 1;
    return true;
  }

 private:
  static constexpr float kMostUnit = 4e9F;  // expansions

  void next_term() {
    if ((turn_ & (~turn_ + 1)) == units_) {
      ++turn_;
      units_ = 1;
    } else {
      units_ *= 2;
    }
  }

  // They have values since begin.
  std::uint32_t unit_;       // expansions
  std::uint32_t turn_;       // of Knuth's doubling
  std::uint32_t units_;      // of this try
  std::uint64_t remaining_;  // expansions
};

}  // namespace krait::detail
