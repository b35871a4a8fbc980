// SPDX-License-Identifier: Apache-2.0
#include "c/model.hpp"

krait_robot krait_diff_drive() {
  krait_robot robot{&krait::c::kModel<krait::DifferentialDrive>, {}, nullptr};
  robot.parameters.diff_drive = krait::c::convert<krait_diff_drive_parameters>(krait::DifferentialDriveParameters());
  return robot;
}
