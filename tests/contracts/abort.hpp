// SPDX-License-Identifier: Apache-2.0
// KRAIT_ASSERT for tests under sanitizers: a broken contract says which and where, and ends the
// program.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace krait::test {

[[noreturn]] inline void end_for(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "krait: broken contract: %s (%s:%d)\n", condition, file, line);
  std::abort();
}

}  // namespace krait::test

#define KRAIT_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : krait::test::end_for(#condition, __FILE__, __LINE__))
