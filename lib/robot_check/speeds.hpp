// SPDX-License-Identifier: Apache-2.0
// What a robot says of its speed and of how it turns and stops, by which searches come to rest and into poses.
#pragma once

#include "robot_check/case.hpp"

namespace krait::detail::checking {

// The functions that a robot does not have return numbers that pass.
void check_speeds(const Case& c);

}  // namespace krait::detail::checking
