// SPDX-License-Identifier: Apache-2.0
#include "firmware/application.hpp"

namespace krait::firmware {

const char* const kModel = "truck";
const bool kHasTrailers = true;

void plan(const Board& board, const Request& request, Report& report) {
  ChainParameters parameters;
  parameters.trailers = request.trailers;
  static const Truck robot(parameters);
  plan_for(board, request, robot, report);
}

}  // namespace krait::firmware
