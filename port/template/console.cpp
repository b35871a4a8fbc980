// SPDX-License-Identifier: Apache-2.0
// The console of a board: its serial port. Registers of the CMSDK APB UART (Arm Cortex-M System Design Kit, 4.3).
#include "bare_metal/console.hpp"

#include <cstdint>

namespace krait::bare_metal {
namespace {

struct Uart {
  volatile std::uint32_t data;
  volatile std::uint32_t state;
  volatile std::uint32_t control;
  volatile std::uint32_t interrupts;
  volatile std::uint32_t divider;
};

constexpr std::uint32_t kTransmitterFull = 1U << 0U;    // in state
constexpr std::uint32_t kTransmitterEnable = 1U << 0U;  // in control
constexpr std::uint32_t kDivider = 25'000'000 / 115'200;

// The arguments of the program, which has no command line.
constexpr char kCommandLine[] = "krait --robot snake:5 --memory 128K";

Uart& uart() { return *reinterpret_cast<Uart*>(0x40004000); }

void send(char c) {
  while ((uart().state & kTransmitterFull) != 0) {
  }
  uart().data = static_cast<std::uint32_t>(c);
}

}  // namespace

void console_write(const char* text) {
  uart().divider = kDivider;
  uart().control = kTransmitterEnable;
  for (; *text != '\0'; ++text) send(*text);
}

// There is nowhere to go: sleeps until the reset.
void console_end(int) {
  for (;;) __asm volatile("wfi");
}

void console_command_line(char* text, std::size_t room) {
  std::size_t i = 0;
  for (; i + 1 < room && i + 1 < sizeof kCommandLine; ++i) text[i] = kCommandLine[i];
  text[i] = '\0';
}

}  // namespace krait::bare_metal
