// SPDX-License-Identifier: Apache-2.0
// The clock: SysTick, a 24-bit counter that counts down (Armv7-M Architecture Reference Manual, B3.3). Its interrupt
// counts the rounds.
#include "bare_metal/main.hpp"

extern "C" void krait_systick();

namespace {

struct SysTick {
  volatile std::uint32_t control;
  volatile std::uint32_t reload;
  volatile std::uint32_t current;
};

constexpr std::uint32_t kEnable = 1U << 0U;
constexpr std::uint32_t kInterrupt = 1U << 1U;
constexpr std::uint32_t kProcessorClock = 1U << 2U;
constexpr std::uint32_t kLast = 0xFFFFFF;  // ticks of a round, less one

SysTick& systick() { return *reinterpret_cast<SysTick*>(0xE000E010); }

volatile std::uint32_t rounds;

}  // namespace

void krait_systick() { rounds = rounds + 1; }

namespace krait::bare_metal {

void start_ticks() {
  systick().reload = kLast;
  systick().current = 0;
  systick().control = kEnable | kInterrupt | kProcessorClock;
  while (systick().current == 0) {  // it loads with the first tick
  }
}

std::uint64_t ticks() {
  std::uint32_t round = 0;
  std::uint32_t left = 0;
  do {
    round = rounds;
    left = systick().current;
  } while (round != rounds);
  return std::uint64_t{round} * (kLast + 1U) + (kLast - left);
}

}  // namespace krait::bare_metal
