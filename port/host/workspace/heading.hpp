// SPDX-License-Identifier: Apache-2.0
// Angles are radians, which people take for degrees.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "host/workspace/printed.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

inline constexpr double kLeastTolerance = 1e-4;  // radians, of headings

inline bool is_over_a_turn(double angle) { return std::abs(angle) > 2 * std::numbers::pi; }

// What to ask of such an angle.
inline std::string degrees_meant(double angle) {
  return printed("were degrees meant? %.6g degrees are %.4f radians", angle, angle * std::numbers::pi / 180);
}

// What to say of such an angle, after "an angle of".
inline std::string angle_over_a_turn(double angle) {
  return printed("%.6g radians is more than a whole turn; ", angle) + degrees_meant(angle);
}

// What to say of such a heading.
inline std::string heading_over_a_turn(double heading) { return "a heading of " + angle_over_a_turn(heading); }

// Throws InputError where the heading is more than a whole turn; `given` is what the line begins with.
inline void check_heading(const std::string& given, double heading) {
  if (is_over_a_turn(heading)) throw InputError(given + ": " + heading_over_a_turn(heading));
}

}  // namespace krait::host
