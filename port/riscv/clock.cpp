// SPDX-License-Identifier: Apache-2.0
// The clock: mtime of the core-local interruptor (the `virt` machine has it where SiFive's parts do).
#include "bare_metal/main.hpp"

namespace krait::bare_metal {

void start_ticks() {}

std::uint64_t ticks() {
  const auto half = [](std::uintptr_t address) { return *reinterpret_cast<volatile std::uint32_t*>(address); };
  constexpr std::uintptr_t kMtime = 0x0200BFF8;
  std::uint32_t high = 0;
  std::uint32_t low = 0;
  do {
    high = half(kMtime + 4);
    low = half(kMtime);
  } while (high != half(kMtime + 4));
  return (std::uint64_t{high} << 32U) | low;
}

}  // namespace krait::bare_metal
