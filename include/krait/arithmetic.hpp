// Refuses compilers that change float arithmetic: the same plan on every target needs each operation as written.
#pragma once

#include <cfloat>

#if defined(__FAST_MATH__)
#error "krait: build without -ffast-math"
#endif
#if FLT_EVAL_METHOD != 0
#error "krait: build for a target that evaluates float as float (on x86: -mfpmath=sse)"
#endif

namespace krait {

// Whether the translation unit that instantiates this keeps products and sums apart and in order.
inline bool exact_arithmetic() {
  const volatile float above_one = 1.0F + 0x1p-12F;
  const volatile float rounded_square = 1.0F + 0x1p-11F;
  const float a = above_one;
  const float residue = a * a - rounded_square;  // 2^-24 when contracted to a fused multiply-add
  const volatile float small = 1.0F;
  const volatile float large = 0x1p26F;
  const float b = small;
  const float c = large;
  const float absorbed = (b + c) - c;  // 1 when reassociated
  return residue == 0.0F && absorbed == 0.0F;
}

}  // namespace krait
