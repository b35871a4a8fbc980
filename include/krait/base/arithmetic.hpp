// SPDX-License-Identifier: Apache-2.0
// Refuses compilers and machines that change float arithmetic: the same plan on every target needs each operation as
// written.
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cfloat>
#include <cstdint>

#if defined(__FAST_MATH__)
#error "krait: build without -ffast-math"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "krait: build without -ffinite-math-only"
#endif
#if FLT_EVAL_METHOD != 0
#error "krait: build for a target that evaluates float as float (on x86: -mfpmath=sse)"
#endif
#if defined(EIGEN_VECTORIZE)
#error "krait: build with -DEIGEN_DONT_VECTORIZE: vectors of floats add up in another order"
#endif

namespace krait {

// A value that the compiler does not know.
template <class T>
[[gnu::always_inline]] inline T unknown(T value) {
  const volatile T hidden = value;
  return hidden;
}

// Inlined into each planner, whose copies' branches would count anew; tests/arithmetic takes both sides of every one,
// in programs built with other options or run in other modes. GCOVR_EXCL_BR_START

// Each of these has another value when the compiler fuses, reorders or simplifies.
[[gnu::always_inline]] inline bool operations_as_written() {
  const float a = unknown(1.0F + 0x1p-12F);
  const float residue = a * a - unknown(1.0F + 0x1p-11F);  // 2^-24 by a fused multiply-add
  const float large = unknown(0x1p26F);
  const float absorbed = (unknown(1.0F) + large) - large;                              // 1 when reassociated
  const float quotient = unknown(5.0F) / 3.0F;                                         // another by a product with 1/3
  const float zero = std::bit_cast<float>(unknown(std::uint32_t{0x80000000})) + 0.0F;  // -0 where signs do not matter
  return residue == 0.0F && absorbed == 0.0F && quotient == unknown(5.0F / 3.0F) &&
         std::bit_cast<std::uint32_t>(zero) == 0;
}

[[gnu::always_inline]] inline bool rounds_to_nearest() {
  const float one = unknown(1.0F);
  return one + 0x1p-25F == one && one - 0x1p-26F == one;
}

[[gnu::always_inline]] inline bool keeps_denormals() {
  const float least_normal = unknown(0x1p-126F);
  const float half = least_normal * 0.5F;
  return half + half == least_normal;
}

// Whether the code around the call, and the floating-point unit, compute as the library was written. All of it is
// inlined: a copy from a file with other flags must not answer.
[[gnu::always_inline]] inline bool exact_arithmetic() {
  return operations_as_written() && rounds_to_nearest() && keeps_denormals();
}
// GCOVR_EXCL_BR_STOP

}  // namespace krait
