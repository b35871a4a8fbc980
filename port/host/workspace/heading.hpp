// SPDX-License-Identifier: Apache-2.0
// Headings are radians, which people take for degrees.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "host/workspace/printed.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

inline constexpr double kLeastTolerance = 1e-4;  // radians, of headings

inline bool is_over_a_turn(double heading) { return std::abs(heading) > 2 * std::numbers::pi; }

// What to say of such a heading.
inline std::string degrees_meant(double heading) {
  return printed(
      "a heading of %.6g radians is more than a whole turn; were degrees meant? %.6g degrees are %.4f radians", heading,
      heading, heading * std::numbers::pi / 180);
}

// Throws InputError where the heading is more than a whole turn; `given` is what the line begins with.
inline void check_heading(const std::string& given, double heading) {
  if (is_over_a_turn(heading)) throw InputError(given + ": " + degrees_meant(heading));
}

}  // namespace krait::host
