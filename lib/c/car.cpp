// SPDX-License-Identifier: Apache-2.0
#include "c/model.hpp"

krait_robot krait_car() {
  krait_robot robot{&krait::c::kModel<krait::Car>, {}, nullptr};
  robot.parameters.chain = krait::c::convert<krait_chain_parameters>(krait::Car::defaults());
  return robot;
}
