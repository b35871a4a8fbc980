// SPDX-License-Identifier: Apache-2.0
// Programs whose stack tests/targets/stack.py must refuse to bound; the definition says which.
#include "firmware/application.hpp"

namespace krait::firmware {
namespace {

volatile int depth = 3;

#if defined(KRAIT_RECURSION)
int odd(int n);
__attribute__((noinline)) int even(int n) { return n == 0 ? 1 : odd(n - 1) + depth; }
__attribute__((noinline)) int odd(int n) { return n == 0 ? 0 : even(n - 1) + depth; }
int answer() { return even(depth); }
#elif defined(KRAIT_GROWING_FRAME)
int answer() {
  auto* const room = static_cast<volatile char*>(__builtin_alloca(static_cast<unsigned>(depth)));
  room[0] = 0;
  return room[0];
}
#elif defined(KRAIT_INDIRECT_CALL)
int (*volatile anywhere)() = nullptr;
int answer() { return anywhere() + depth; }
#endif

}  // namespace

int run(const Board&, int, const char* const*) { return answer(); }

}  // namespace krait::firmware
