// SPDX-License-Identifier: Apache-2.0
// The robot of a program for one robot, of which krait robot --cpp wrote the header.
#include "compiled.hpp"
#include "firmware/application.hpp"

namespace krait::firmware {

const char* const kModel = robot_compiled::kName;
const bool kHasTrailers = false;

Robot robot_for(const Request&) {
  static const robot_compiled::Robot robot = robot_compiled::make();
  return robot;
}

}  // namespace krait::firmware
