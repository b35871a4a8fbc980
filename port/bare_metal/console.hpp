// SPDX-License-Identifier: Apache-2.0
// The input, output and exit of a bare-metal program. semihosting.cpp implements them through a debugger or an
// emulator; a board may bring its own (port/template).
#pragma once

#include <cstddef>

namespace krait::bare_metal {

// Writes text, as it is.
void console_write(const char* text);

// Ends the program with an exit code: 0 solved, 1 an honest no, 2 bad input, 3 a bug.
[[noreturn]] void console_end(int code);

// Writes the command line, the program's name first, and a NUL: at most `room` characters in all.
void console_command_line(char* text, std::size_t room);

}  // namespace krait::bare_metal
