// SPDX-License-Identifier: Apache-2.0
// How narrow and how wide a robot's bodies are, whatever its hitches do.
#pragma once

#include "host/robot_file/robot_file.hpp"

namespace krait::host {

// Every body holds a disc of radius `inner`, has no point further than `outer` from the middle of that disc, and has
// that middle within `spread` of the robot's position; metres. Of a disc: inner = outer, spread = 0.
struct Girth {
  double inner = 0;
  double outer = 0;
  double spread = 0;
};

// The largest disc in the narrowest body, and the least `outer` that holds for all bodies with discs of that radius or
// more: the largest in each.
Girth girth_of(const RobotSpec& robot);

}  // namespace krait::host
