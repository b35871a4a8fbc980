// SPDX-License-Identifier: Apache-2.0
/// \file
/// Float arithmetic that has the same bits on every target: only IEEE-754 + - * / sqrt, comparisons and
/// conversions whose range is checked. No libm trigonometry, no fused operations, no double. Refuses compilers and
/// machines that change float arithmetic.
#pragma once

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

#if defined(__FAST_MATH__)
#error "krait: build without -ffast-math"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "krait: build without -ffinite-math-only"
#endif
#if FLT_EVAL_METHOD != 0
#error "krait: build for a target that evaluates float as float (on x86: -mfpmath=sse)"
#endif

/// The library: a planner, its robots and its scenes. Metres, radians and seconds, unless something else is said;
/// nothing allocates or throws, but for krait/robot_check.hpp.
namespace krait {

inline constexpr float kPi = 3.14159265358979F;                             ///< pi, rounded to a float
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();  ///< positive infinity
inline constexpr float kMaxAngle = 8192.0F;  ///< radians: the most, either way, of which there is a sine
inline constexpr float kSmallAngle = 0.7F;   ///< radians: the largest argument of math::small_sin_cos, either way

/// The sine and cosine of an angle, and so a direction: of a float, or of several, one a lane.
template <class Real>
struct SinCosOf {
  Real sin;  ///< -1 … 1
  Real cos;  ///< -1 … 1
};
using SinCos = SinCosOf<float>;  ///< of one angle

/// Whether x is a number: false for NaN and infinities. O(1).
inline bool finite(float x) { return x - x == 0.0F; }

/// Arithmetic that has the same bits on every target. Everything here is O(1) and has no state.
namespace math {

/// a * b, rounded. Where a sum and a difference of products stand side by side, GCC makes one vector instruction of
/// them that does not round the products (vfmaddsub), even with -ffp-contract=off: one of them is hidden from it.
inline float product(float a, float b) {
  float result = a * b;
#if defined(__FMA__) && defined(__GNUC__) && !defined(__clang__)
  __asm__("" : "+x"(result));
#endif
  return result;
}

/// |x|; NaN stays NaN.
inline float absolute(float x) { return std::fabs(x); }

/// x, or the end of [low, high] that is nearer to it. NaN passes neither comparison and becomes `low`.
inline float clamp(float x, float low, float high) {
  if (!(x > low)) return low;
  return x < high ? x : high;
}

/// Radians: an angle less the nearest multiple of pi/2, by Cody and Waite's three parts of it: of a float, or of one a
/// lane. `quarter_turns` is that multiple, a whole number.
template <class Real>
inline Real reduced_angle(Real x, Real quarter_turns) {
  return ((x - quarter_turns * 1.5703125F) - quarter_turns * 4.837512969970703125e-4F) -
         quarter_turns * 7.54978995489188216e-8F;
}

/// Sine and cosine of r radians on [-pi/4, pi/4]: minimax polynomials (Cephes sinf, cosf).
template <class Real>
inline SinCosOf<Real> reduced_sin_cos(Real r) {
  const Real z = r * r;
  return {((-1.9515295891e-4F * z + 8.3321608736e-3F) * z - 1.6666654611e-1F) * z * r + r,
          ((2.443315711809948e-5F * z - 1.388731625493765e-3F) * z + 4.166664568298827e-2F) * z * z - 0.5F * z + 1.0F};
}

inline constexpr float kQuarterTurns = 0.636619772367581F;  ///< quarter turns in a radian
inline constexpr float kQuarterShift = 8192.0F;             ///< a multiple of 4 above the most quarter turns

/// Sine and cosine of x radians, error below 8e-8 for |x| <= kMaxAngle; NaN beyond and for NaN.
inline SinCos sin_cos(float x) {
  if (!(x * x <= kMaxAngle * kMaxAngle)) [[unlikely]] {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    return {nan, nan};
  }
  const auto quadrant = static_cast<std::int32_t>(x * kQuarterTurns + (kQuarterShift + 0.5F));
  const SinCos at = reduced_sin_cos(reduced_angle(x, static_cast<float>(quadrant) - kQuarterShift));
  const bool swap = (quadrant & 1) != 0;
  const float sine = swap ? at.cos : at.sin;
  const float cosine = swap ? at.sin : at.cos;
  return {(quadrant & 2) != 0 ? -sine : sine, ((quadrant + 1) & 2) != 0 ? -cosine : cosine};
}

/// Sine and cosine of a small angle in radians, or of one a lane, error below 1.1e-7 for |x| <= kSmallAngle: the first
/// terms of their Taylor series, but with such coefficients of the last two that the polynomial's largest error in that
/// range is least (minimax).
template <class Real>
inline SinCosOf<Real> small_sin_cos(Real x) {
  const Real z = x * x;
  const Real sine = x + x * (z * (-1.0F / 6.0F + z * (8.332922294e-3F - z * 1.962487165e-4F)));
  return {sine, 1.0F + z * (-0.5F + z * (4.166325879e-2F - z * 1.370074570e-3F))};
}

/// Radians: the angle of the vector (x, y), in [-pi, pi], error below 4e-7; 0 for the zero vector.
float atan2(float y, float x);

/// Natural logarithm of a positive normal number, error below 2 units in the last place near 1 and 3e-7 relative
/// elsewhere; -infinity for 0 and below, NaN for NaN.
float log(float x);

/// The same direction as that of x radians, in [-pi, pi]; for |x| <= kMaxAngle. NaN where x has more than kMaxAngle
/// turns, and for NaN.
float wrap_angle(float x);

/// `value`, of which the compiler does not know what it is. Costs a store and a load.
template <class T>
[[gnu::always_inline]] inline T unknown(T value) {
  const volatile T hidden = value;
  return hidden;
}

// Inlined into the functions of each robot, where its branches would count again; tests/arithmetic runs both sides of
// every one, in programs built with other options or run in other modes. GCOVR_EXCL_BR_START

/// Whether the code around the call neither fuses, reorders nor simplifies float operations.
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

/// Whether the floating-point unit rounds to nearest, ties to even.
[[gnu::always_inline]] inline bool rounds_to_nearest() {
  const float one = unknown(1.0F);
  return one + 0x1p-25F == one && one - 0x1p-26F == one;
}

/// Whether the floating-point unit neither flushes denormal results nor reads denormal operands as 0.
[[gnu::always_inline]] inline bool keeps_denormals() {
  const float least_normal = unknown(0x1p-126F);
  const float half = least_normal * 0.5F;
  return half + half == least_normal;
}

/// Whether the code around the call, and the floating-point unit, compute as the library was written. All of it is
/// inlined: a copy from a file with other flags must not answer. Costs a dozen operations.
[[gnu::always_inline]] inline bool exact_arithmetic() {
  return operations_as_written() && rounds_to_nearest() && keeps_denormals();
}
// GCOVR_EXCL_BR_STOP

}  // namespace math
}  // namespace krait
