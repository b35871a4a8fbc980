// SPDX-License-Identifier: Apache-2.0
// Vector table and reset of a Cortex-M (Armv7-M Architecture Reference Manual, B1.5; Armv8-M, B3.30).
// Section numbers in this file are the Armv7-M manual's.
#include <cstdint>

#include "bare_metal/main.hpp"
#include "bare_metal/memory.hpp"

extern "C" {
[[noreturn]] void krait_reset();
void krait_fault();    // fault.cpp
void krait_systick();  // systick.cpp
}

namespace {

using Handler = void (*)();

struct VectorTable {
  void* stack;
  Handler handlers[15];  // exceptions 1 to 15
};

// Not used where the core has a stack limit and no floating point.
[[maybe_unused]] volatile std::uint32_t& at(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

// Coprocessors 10 and 11, the floating-point unit, for everyone (B3.2.20).
void enable_floating_point() {
#if defined(__ARM_FP)
  constexpr std::uintptr_t kCpacr = 0xE000ED88;
  at(kCpacr) = at(kCpacr) | (0xFU << 20U);
  __asm volatile("dsb\n isb" ::: "memory");
#endif
}

// Makes an overflow of the stack a fault: by its limit where the core has one, else by a region without access below
// it (B3.5), which must be larger than any frame. That region begins 32 KB below RAM, so RAM begins at a multiple of
// 32 KB. Fault handlers run without it.
void guard_stack() {
#if __ARM_ARCH >= 8
  __asm volatile("msr msplim, %0" ::"r"(krait_stack_limit));
#else
  constexpr std::uintptr_t kMpuControl = 0xE000ED94;
  constexpr std::uintptr_t kMpuRegionBase = 0xE000ED9C;
  constexpr std::uintptr_t kMpuRegionSize = 0xE000EDA0;
  constexpr std::uint32_t kGuardBytes = 32 * 1024;
  constexpr std::uint32_t kGuardSize = 14U << 1U;  // 2^(14 + 1) bytes
  constexpr std::uint32_t kNoExecution = 1U << 28U;
  constexpr std::uint32_t kRegionEnable = 1U << 0U;
  constexpr std::uint32_t kRegionNumber = 1U << 4U;  // the number, 0, is in the low bits
  constexpr std::uint32_t kEnable = 1U << 0U;
  constexpr std::uint32_t kDefaultMapElsewhere = 1U << 2U;
  at(kMpuRegionBase) = (reinterpret_cast<std::uintptr_t>(krait_stack_limit) - kGuardBytes) | kRegionNumber;
  at(kMpuRegionSize) = kNoExecution | kGuardSize | kRegionEnable;
  at(kMpuControl) = kDefaultMapElsewhere | kEnable;
  __asm volatile("dsb\n isb" ::: "memory");
#endif
}

}  // namespace

// Exceptions that this program does not use are faults; interrupts are never enabled.
extern "C" __attribute__((section(".start"), used)) const VectorTable krait_vectors = {
    krait_stack_top,
    {krait_reset, krait_fault, krait_fault, krait_fault, krait_fault, krait_fault, krait_fault, krait_fault,
     krait_fault, krait_fault, krait_fault, krait_fault, krait_fault, krait_fault, krait_systick}};

void krait_reset() {
  enable_floating_point();
  guard_stack();
  krait_main();
}
