// SPDX-License-Identifier: Apache-2.0
// Reset, traps and protection of a RISC-V hart in machine mode (RISC-V Privileged Architecture).
#include <cstdint>

#include "bare_metal/main.hpp"
#include "bare_metal/memory.hpp"

extern "C" {
[[noreturn]] void krait_reset();
void krait_trap();
[[noreturn, gnu::used]] void krait_start();
[[noreturn, gnu::used]] void krait_report_trap(std::uintptr_t cause, std::uintptr_t pc, std::uintptr_t value,
                                               std::uintptr_t stack);
}

// Every hart but the first sleeps.
__attribute__((naked, section(".start"), used)) void krait_reset() {
  __asm volatile(
      "  csrr t0, mhartid\n"
      "1:\n"
      "  beqz t0, 2f\n"
      "  wfi\n"
      "  j 1b\n"
      "2:\n"
      "  .option push\n"
      "  .option norelax\n"
      "  la gp, __global_pointer$\n"
      "  .option pop\n"
      "  la sp, krait_stack_top\n"
      "  la t0, krait_trap\n"
      "  csrw mtvec, t0\n"
#ifdef __riscv_flen
      "  li t0, 0x2000\n"  // mstatus.FS: the floating-point unit is on
      "  csrs mstatus, t0\n"
      "  fscsr zero\n"
#endif
      "  j krait_start\n");
}

// Nothing returns from a trap: the whole stack is free for the report.
__attribute__((naked, aligned(4))) void krait_trap() {
  __asm volatile(
      "  csrr a0, mcause\n"
      "  csrr a1, mepc\n"
      "  csrr a2, mtval\n"
      "  mv a3, sp\n"
      "  la sp, krait_stack_top\n"
      "  j krait_report_trap\n");
}

// Makes program and scene, which lie below the stack, read-only for machine mode too: one locked region, a naturally
// aligned power of two. An overflow of the stack is then a trap.
static void protect_flash() {
  const auto begin = reinterpret_cast<std::uintptr_t>(krait_flash_start);
  const auto size = reinterpret_cast<std::uintptr_t>(krait_scene_end) - begin;
  const std::uintptr_t address = (begin >> 2U) | ((size >> 3U) - 1U);
  const std::uintptr_t locked_read_execute = 0x9D;
  __asm volatile("csrw pmpaddr0, %0\n csrw pmpcfg0, %1" ::"r"(address), "r"(locked_read_execute) : "memory");
}

void krait_start() {
  protect_flash();
  krait_main();
}

void krait_report_trap(std::uintptr_t cause, std::uintptr_t pc, std::uintptr_t value, std::uintptr_t stack) {
  using krait::bare_metal::NamedWord;
  const NamedWord words[] = {{"mepc", pc}, {"mcause", cause}, {"mtval", value}, {"sp", stack}};
  const bool overflow = stack < reinterpret_cast<std::uintptr_t>(krait_stack_limit);
  krait::bare_metal::report_fault(overflow ? "the stack overflowed" : "the processor trapped", words, 4);
}
