// SPDX-License-Identifier: Apache-2.0
// A semihosting call of RISC-V: EBREAK between two instructions without effect that mark it, all uncompressed and in
// one page; operation in a0, argument in a1, result in a0 (RISC-V Semihosting, chapter 2).
#include <cstdint>

extern "C" __attribute__((naked, aligned(16))) std::uintptr_t krait_semihosting(std::uintptr_t, const void*) {
  __asm volatile(
      "  .option push\n"
      "  .option norvc\n"
      "  slli zero, zero, 0x1f\n"
      "  ebreak\n"
      "  srai zero, zero, 7\n"
      "  .option pop\n"
      "  ret\n");
}
