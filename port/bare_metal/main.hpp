// SPDX-License-Identifier: Apache-2.0
// What the start-up code of every architecture calls, and what it must provide.
#pragma once

#include <cstdint>

// From the reset on, with a stack and the floating-point unit ready: prepares memory, runs the application, ends.
extern "C" [[noreturn]] void krait_main();

namespace krait::bare_metal {

// By the architecture: starts the counter behind ticks(), which never goes back.
void start_ticks();
std::uint64_t ticks();

// Says what happened, then ends with the exit code of a bug. `values` are `count` words with their names.
struct NamedWord {
  const char* name;
  std::uintptr_t value;
};
[[noreturn]] void report_fault(const char* what, const NamedWord* words, int count);

}  // namespace krait::bare_metal
