// SPDX-License-Identifier: Apache-2.0
// A stack that overflows must be reported, not write into data.
#include "firmware/application.hpp"

namespace krait::firmware {
namespace {

volatile int never = 0;

int dive(int depth) {
  volatile char frame[64];
  frame[0] = static_cast<char>(depth);
  if (never != 0) return 0;
  return dive(depth + 1) + frame[0];
}

}  // namespace

int run(const Board&, int, const char* const*) { return dive(0); }

}  // namespace krait::firmware
