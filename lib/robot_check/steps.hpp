// SPDX-License-Identifier: Apache-2.0
// Whether what a robot offers beside derivative agrees with it: its leading components, its own integration, and how
// fast it says to be.
#pragma once

#include "robot_check/case.hpp"

namespace krait::detail::checking {

void check_leading(const Case& c);

// Checks a robot that integrates its leading components first.
void check_integration(const Case& c);

// Checks a step as long as the library makes them of a robot that says how fast it is.
void check_fastest_rate(const Case& c);

}  // namespace krait::detail::checking
