// SPDX-License-Identifier: Apache-2.0
#include "firmware/application.hpp"

namespace krait::firmware {

const char* const kModel = "diff_drive";
const bool kHasTrailers = false;

void plan(const Board& board, const Request& request, Report& report) {
  static const DifferentialDrive robot{DifferentialDriveParameters()};
  plan_for(board, request, robot, report);
}

}  // namespace krait::firmware
