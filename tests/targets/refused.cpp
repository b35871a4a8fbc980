// SPDX-License-Identifier: Apache-2.0
// Programs that a board's linker script must refuse; the definition says which.
#include <cstddef>
#include <cstdlib>

#include "firmware/application.hpp"

#ifdef KRAIT_USE_OWN_NEW
void* operator new(std::size_t) {
  static char block[16];
  return block;
}
void operator delete(void*) noexcept {}
void operator delete(void*, std::size_t) noexcept {}
#endif

namespace krait::firmware {

#ifdef KRAIT_USE_THREAD_LOCAL
thread_local int counter;
#endif

volatile int wanted = 1;
int* volatile kept;

int run(const Board&, int, const char* const*) {
#if defined(KRAIT_USE_MALLOC)
  kept = static_cast<int*>(std::malloc(sizeof(int)));
#elif defined(KRAIT_USE_NEW) || defined(KRAIT_USE_OWN_NEW)
  kept = new int(wanted);
#elif defined(KRAIT_USE_THROW)
  if (wanted == 1) throw 1;
#elif defined(KRAIT_USE_THREAD_LOCAL)
  counter = wanted;
  kept = &counter;
#endif
  return kDone;
}

}  // namespace krait::firmware
