// SPDX-License-Identifier: Apache-2.0
// The painted stack tells how much was used: a known frame more, to within what the calls around it need.
#include "firmware/application.hpp"

namespace krait::firmware {
namespace {

constexpr std::size_t kFrame = 1000;

__attribute__((noinline)) void use() {
  volatile char frame[kFrame];
  for (volatile char& byte : frame) byte = 0;
}

}  // namespace

int run(const Board& board, int, const char* const*) {
  const std::size_t before = board.stack_bytes();
  use();
  const std::size_t grown = board.stack_bytes() - before;
  const bool good = before > 0 && before < 512 && grown <= kFrame + 64 && grown + 256 >= kFrame;
  board.port.log(board.port.context, good ? "passed\n" : "failed\n");
  return good ? kDone : kOwnBug;
}

}  // namespace krait::firmware
