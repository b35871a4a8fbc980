// SPDX-License-Identifier: Apache-2.0
// Fault report of a Cortex-M (Armv7-M Architecture Reference Manual, B1.5.6 stack frame, B3.2.15 to B3.2.18 registers).
#include "bare_metal/main.hpp"
#include "bare_metal/memory.hpp"

extern "C" {
void krait_fault();
[[noreturn, gnu::used]] void krait_report_fault(std::uintptr_t frame, std::uintptr_t pc, std::uintptr_t lr);
}

// Reads what the exception pushed, unless the stack has overflowed and nothing was; then takes the whole stack for the
// report, since nothing returns.
__attribute__((naked)) void krait_fault() {
  __asm volatile(
      "  tst lr, #4\n"
      "  ite eq\n"
      "  mrseq r0, msp\n"
      "  mrsne r0, psp\n"
      "  movs r1, #0\n"
      "  movs r2, #0\n"
      "  ldr r3, =krait_stack_limit\n"
      "  cmp r0, r3\n"
      "  itt hi\n"
      "  ldrhi r1, [r0, #24]\n"
      "  ldrhi r2, [r0, #20]\n"
      "  ldr r3, =krait_stack_top\n"
      "  mov sp, r3\n"
      "  b krait_report_fault\n"
      "  .ltorg\n");
}

void krait_report_fault(std::uintptr_t frame, std::uintptr_t pc, std::uintptr_t lr) {
  using krait::bare_metal::NamedWord;
  const auto at = [](std::uintptr_t address) { return *reinterpret_cast<volatile std::uint32_t*>(address); };
  const NamedWord words[] = {{"pc", pc},
                             {"lr", lr},
                             {"cfsr", at(0xE000ED28)},
                             {"hfsr", at(0xE000ED2C)},
                             {"mmfar", at(0xE000ED34)},
                             {"bfar", at(0xE000ED38)}};
  const bool overflow = frame <= reinterpret_cast<std::uintptr_t>(krait_stack_limit);
  krait::bare_metal::report_fault(overflow ? "the stack overflowed" : "the processor faulted", words, 6);
}
