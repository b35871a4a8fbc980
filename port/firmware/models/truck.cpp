// SPDX-License-Identifier: Apache-2.0
#include "firmware/application.hpp"

namespace krait::firmware {

const char* const kModel = "truck";
const bool kHasTrailers = true;

Robot robot_for(const Request& request) {
  ChainParameters parameters;
  parameters.trailers = request.trailers;
  static const Truck robot(parameters);
  return robot;
}

}  // namespace krait::firmware
