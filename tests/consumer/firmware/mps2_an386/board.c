/* SPDX-License-Identifier: Apache-2.0 */
/* Start-up of a Cortex-M4 with a floating-point unit, and text and exit code by semihosting. */
#include "../board.h"

#include <stdint.h>

extern uint32_t stack_top[], data_image[], data_start[], data_end[], bss_start[], bss_end[]; /* of memory.ld */
int main(void);
void reset(void);

static void semihosting(uint32_t operation, const void* argument) {
  register uint32_t r0 __asm("r0") = operation;
  register const void* r1 __asm("r1") = argument;
  __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

static void leave(uint32_t code) {
  const uint32_t exit[2] = {0x20026, code}; /* the application ended, with this code */
  for (;;) semihosting(0x20, exit);         /* SYS_EXIT_EXTENDED */
}

static void fault(void) {
  write_text("fault\n");
  leave(99);
}

void write_text(const char* text) { semihosting(0x04, text); } /* SYS_WRITE0 */

void reset(void) {
  *(volatile uint32_t*)0xE000ED88 |= 0xFU << 20U; /* CPACR: the floating-point unit */
  __asm volatile("dsb\n isb");
  const uint32_t* image = data_image;
  for (uint32_t* word = data_start; word != data_end; ++word) *word = *image++;
  for (uint32_t* word = bss_start; word != bss_end; ++word) *word = 0;
  leave((uint32_t)main());
}

typedef void (*handler)(void);
__attribute__((section(".vectors"), used)) static const struct {
  uint32_t* stack;
  handler handlers[15];
} vectors = {stack_top,
             {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault}};
