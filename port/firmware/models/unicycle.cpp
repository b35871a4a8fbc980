// SPDX-License-Identifier: Apache-2.0
#include "firmware/application.hpp"

namespace krait::firmware {

const char* const kModel = "unicycle";
const bool kHasTrailers = false;

Robot robot_for(const Request&) {
  static const Unicycle robot{UnicycleParameters()};
  return robot;
}

}  // namespace krait::firmware
