// SPDX-License-Identifier: Apache-2.0
// A board with nothing but a log, where there is an operating system or node.
#include <cstdio>

#include "firmware/application.hpp"

int main() {
  krait::firmware::Board board{};
  board.port.log = [](void*, const char* text) { std::fputs(text, stdout); };
  return krait::firmware::run(board, 0, nullptr);
}
