// SPDX-License-Identifier: Apache-2.0
// What check.py must find; the definition says which. The function is krait's by its name only.
#include <cstdlib>
#include <typeinfo>

namespace krait {

volatile const int wanted = 1;
void forbidden();

#if defined(KRAIT_MALLOC)
void use(void* block);
void forbidden() { use(std::malloc(static_cast<std::size_t>(wanted))); }
#elif defined(KRAIT_NEW)
void use(int* object);
void forbidden() { use(new int(wanted)); }
#elif defined(KRAIT_THROW)
void forbidden() {
  if (wanted == 1) throw 1;
}
#elif defined(KRAIT_CATCH)
void called();
void forbidden() {
  try {
    called();
  } catch (...) {
  }
}
#elif defined(KRAIT_VIRTUAL)
struct Shape {
  virtual int corners() const;
};
int Shape::corners() const { return wanted; }
#elif defined(KRAIT_CONSTRUCTOR)
int begin();
const int begun = begin();
void forbidden() { static_cast<void>(begun); }
#elif defined(KRAIT_WRITABLE)
int counter = 0;
void forbidden() { ++counter; }
#elif defined(KRAIT_THREAD_LOCAL)
thread_local int counter = 1;
void forbidden() { ++counter; }
#elif defined(KRAIT_GUARD)
int begin();
int once() {
  static const int begun = begin();
  return begun;
}
#elif defined(KRAIT_LIBM)
extern "C" float sinf(float);
float sine(float x) { return sinf(x); }
#endif

}  // namespace krait
