// SPDX-License-Identifier: Apache-2.0
// A heading on a command line: radians, which people take for degrees.
#pragma once

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "host/workspace/workspace.hpp"

namespace krait::host {

inline constexpr double kLeastTolerance = 1e-4;  // radians, of headings

// Throws InputError where the heading is more than a whole turn; `given` is what the line begins with.
inline void check_heading(const std::string& given, double heading) {
  if (std::abs(heading) <= 2 * std::numbers::pi) return;
  char line[160];
  std::snprintf(
      line, sizeof line,
      ": a heading of %.6g radians is more than a whole turn; were degrees meant? %.6g degrees are %.4f radians",
      heading, heading, heading * std::numbers::pi / 180);
  throw InputError(given + line);
}

}  // namespace krait::host
