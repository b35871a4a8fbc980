// SPDX-License-Identifier: Apache-2.0
// Whether travel and quick_bound really bound the motion, and place follows it.
#pragma once

#include "robot_check/case.hpp"

namespace krait::detail::checking {

void check_travel(const Case& c);
void check_quick_bound(const Case& c);

// Looks again, sixteen times as finely, at the part of the step in which a frame moves most: what is continuous moves a
// sixteenth there.
void check_place_follows(const Case& c);

}  // namespace krait::detail::checking
