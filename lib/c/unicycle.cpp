// SPDX-License-Identifier: Apache-2.0
#include "c/model.hpp"

krait_robot krait_unicycle() {
  krait_robot robot{&krait::c::kModel<krait::Unicycle>, {}, nullptr};
  robot.parameters.unicycle = krait::c::convert<krait_unicycle_parameters>(krait::UnicycleParameters());
  return robot;
}
