// SPDX-License-Identifier: Apache-2.0
#include "firmware/application.hpp"

namespace krait::firmware {

const char* const kModel = "diff_drive";
const bool kHasTrailers = false;

Robot robot_for(const Request&) {
  static const DifferentialDrive robot{DifferentialDriveParameters()};
  return robot;
}

}  // namespace krait::firmware
