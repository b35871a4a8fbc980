// SPDX-License-Identifier: Apache-2.0
#include "firmware/application.hpp"

namespace krait::firmware {

const char* const kModel = "car";
const bool kHasTrailers = false;

namespace {

// In a function of its own: what making it needs does not lie on the stack while it plans.
[[gnu::noinline]] const Car& robot() {
  static const Car car(Car::defaults());
  return car;
}

}  // namespace

void plan(const Board& board, const Request& request, Report& report) { plan_for(board, request, robot(), report); }

}  // namespace krait::firmware
