// SPDX-License-Identifier: Apache-2.0
// Fault report of a Cortex-M (Armv7-M Architecture Reference Manual, B1.5.6 stack frame, B3.2.15 to B3.2.18 registers,
// which Armv6-M does not have).
#include "bare_metal/main.hpp"
#include "bare_metal/memory.hpp"

extern "C" {
void krait_fault();
[[noreturn, gnu::used]] void krait_report_fault(std::uintptr_t frame, std::uintptr_t pc, std::uintptr_t lr);
}

// Reads what the exception pushed, unless the stack has overflowed and nothing was; then takes the whole stack for the
// report, since nothing returns. In instructions that Armv6-M has, too.
__attribute__((naked)) void krait_fault() {
  __asm volatile(
      "  movs r0, #4\n"
      "  mov r1, lr\n"
      "  tst r1, r0\n"
      "  mrs r0, msp\n"
      "  beq 1f\n"
      "  mrs r0, psp\n"
      "1:\n"
      "  movs r1, #0\n"
      "  movs r2, #0\n"
      "  ldr r3, =krait_stack_limit\n"
      "  cmp r0, r3\n"
      "  bls 2f\n"
      "  ldr r1, [r0, #24]\n"
      "  ldr r2, [r0, #20]\n"
      "2:\n"
      "  ldr r3, =krait_stack_top\n"
      "  mov sp, r3\n"
      "  bl krait_report_fault\n"
      "  .ltorg\n");
}

void krait_report_fault(std::uintptr_t frame, std::uintptr_t pc, std::uintptr_t lr) {
  using krait::bare_metal::NamedWord;
  const bool overflow = frame <= reinterpret_cast<std::uintptr_t>(krait_stack_limit);
  const char* const what = overflow ? "the stack overflowed" : "the processor faulted";
#ifdef __thumb2__
  const auto at = [](std::uintptr_t address) { return *reinterpret_cast<volatile std::uint32_t*>(address); };
  const NamedWord words[] = {{"pc", pc},
                             {"lr", lr},
                             {"cfsr", at(0xE000ED28)},
                             {"hfsr", at(0xE000ED2C)},
                             {"mmfar", at(0xE000ED34)},
                             {"bfar", at(0xE000ED38)}};
  krait::bare_metal::report_fault(what, words, 6);
#else
  const NamedWord words[] = {{"pc", pc}, {"lr", lr}};
  krait::bare_metal::report_fault(what, words, 2);
#endif
}
