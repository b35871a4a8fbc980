// SPDX-License-Identifier: Apache-2.0
#include "firmware/application.hpp"

namespace krait::firmware {

const char* const kModel = "snake";
const bool kHasTrailers = true;

Robot robot_for(const Request& request) {
  ChainParameters parameters;
  parameters.trailers = request.trailers;
  static const Snake robot(parameters);
  return robot;
}

}  // namespace krait::firmware
