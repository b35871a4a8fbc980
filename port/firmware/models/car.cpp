#include "firmware/application.hpp"

namespace krait::firmware {

const char* const kModel = "car";
const bool kHasTrailers = false;

void plan(const Board& board, const Request& request, Report& report) {
  static const Car robot(Car::defaults());
  plan_for(board, request, robot, report);
}

}  // namespace krait::firmware
