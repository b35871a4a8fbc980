// SPDX-License-Identifier: Apache-2.0
// Instructions so far, under an emulator that counts them: exactly on RISC-V, else to within a tick of the clock.
#pragma once

#include <cstdint>

#include "firmware/board.hpp"

namespace krait::bench {

inline std::uint64_t instructions([[maybe_unused]] const firmware::Board& board) {
#if defined(__riscv) && __riscv_xlen == 64
  std::uint64_t count = 0;
  __asm volatile("csrr %0, minstret" : "=r"(count));
  return count;
#elif defined(__riscv)
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t again = 0;
  do {
    __asm volatile("csrr %0, minstreth\n csrr %1, minstret\n csrr %2, minstreth"
                   : "=&r"(high), "=&r"(low), "=&r"(again));
  } while (high != again);
  return (std::uint64_t{high} << 32U) | low;
#else
  return board.port.clock(board.port.context);
#endif
}

}  // namespace krait::bench
