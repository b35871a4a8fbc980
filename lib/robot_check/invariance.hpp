// SPDX-License-Identifier: Apache-2.0
// Whether a robot moves alike wherever it stands and in whichever direction.
#pragma once

#include "robot_check/case.hpp"

namespace krait::detail::checking {

// Elsewhere, and turned by the angle: each as far as the ranges say that it should move alike.
void check_invariance(const Case& c, double angle);

}  // namespace krait::detail::checking
