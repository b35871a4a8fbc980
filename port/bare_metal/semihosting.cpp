// SPDX-License-Identifier: Apache-2.0
// The console by semihosting ("Semihosting for AArch32 and AArch64", Arm; RISC-V uses the same operations).
#include <cstdint>

#include "bare_metal/console.hpp"

// By the architecture: the instruction that a debugger handles as a call. Returns the operation's result.
extern "C" std::uintptr_t krait_semihosting(std::uintptr_t operation, const void* argument);

namespace krait::bare_metal {
namespace {

enum Operation : std::uintptr_t { kWrite0 = 0x04, kGetCommandLine = 0x15, kExitExtended = 0x20 };

constexpr std::uintptr_t kApplicationExit = 0x20026;

}  // namespace

void console_write(const char* text) { krait_semihosting(kWrite0, text); }

void console_end(int code) {
  const std::uintptr_t block[] = {kApplicationExit, static_cast<std::uintptr_t>(code)};
  krait_semihosting(kExitExtended, block);
  for (;;) {
  }
}

void console_command_line(char* text, std::size_t room) {
  const std::uintptr_t block[] = {reinterpret_cast<std::uintptr_t>(text), room};
  if (krait_semihosting(kGetCommandLine, block) != 0) text[0] = '\0';
}

}  // namespace krait::bare_metal
