// SPDX-License-Identifier: Apache-2.0
#include "firmware/application.hpp"

namespace krait::firmware {

const char* const kModel = "car";
const bool kHasTrailers = false;

Robot robot_for(const Request&) {
  static const Car robot(Car::defaults());
  return robot;
}

}  // namespace krait::firmware
