// SPDX-License-Identifier: Apache-2.0
#include "c/model.hpp"

krait_robot krait_truck(int trailers) {
  krait::ChainParameters parameters;
  parameters.trailers = trailers;
  krait_robot robot{&krait::c::kModel<krait::Truck>, {}, nullptr};
  robot.parameters.chain = krait::c::convert<krait_chain_parameters>(parameters);
  return robot;
}
