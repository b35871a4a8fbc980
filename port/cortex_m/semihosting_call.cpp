// SPDX-License-Identifier: Apache-2.0
// A semihosting call of a Cortex-M: BKPT 0xAB, operation in r0, argument in r1, result in r0.
#include <cstdint>

extern "C" __attribute__((naked)) std::uintptr_t krait_semihosting(std::uintptr_t, const void*) {
  __asm volatile("bkpt 0xAB\n bx lr");
}
