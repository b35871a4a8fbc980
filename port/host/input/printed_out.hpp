// SPDX-License-Identifier: Apache-2.0
// Whether what a program has printed got where it was to go.
#pragma once

#include <cstdio>

namespace krait::host {

inline constexpr const char* kPrintingFailed = "standard output cannot be written";

// Writes what is still held back. False where that, or something before it, has got lost.
inline bool printed_out() { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

}  // namespace krait::host
