// SPDX-License-Identifier: Apache-2.0
// Float arithmetic that has the same bits on every target: only IEEE-754 + - * / sqrt, comparisons and
// conversions whose range is checked. No libm trigonometry, no fused operations, no double.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace krait {

inline constexpr float kPi = 3.14159265358979F;
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Vec2 {
  float x;
  float y;
};

// a * b, rounded. Where a sum and a difference of products stand side by side, GCC makes one vector instruction of them
// that does not round the products (vfmaddsub), even with -ffp-contract=off: one of them is hidden from it.
inline float product(float a, float b) {
  float result = a * b;
#if defined(__FMA__) && defined(__GNUC__) && !defined(__clang__)
  __asm__("" : "+x"(result));
#endif
  return result;
}

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(float k, Vec2 a) { return {k * a.x, k * a.y}; }
inline float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
inline float cross(Vec2 a, Vec2 b) { return a.x * b.y - product(a.y, b.x); }
inline float length(Vec2 a) { return std::sqrt(dot(a, a)); }

// False for NaN.
inline bool finite(float x) { return x - x == 0.0F; }
inline bool finite(Vec2 a) { return finite(a.x) && finite(a.y); }

inline float absolute(float x) { return std::fabs(x); }

// NaN passes neither comparison and becomes `low`.
inline float clamp(float x, float low, float high) {
  if (!(x > low)) return low;
  return x < high ? x : high;
}

template <class Real>
struct SinCosOf {
  Real sin;
  Real cos;
};
using SinCos = SinCosOf<float>;

// The vector turned by the angle.
inline Vec2 turned(SinCos angle, Vec2 p) {
  return {angle.cos * p.x - product(angle.sin, p.y), angle.sin * p.x + product(angle.cos, p.y)};
}

inline constexpr float kMaxAngle = 8192.0F;  // radians

// Sine and cosine, error below 8e-8 for |x| <= kMaxAngle; NaN beyond and for NaN.
// Cody-Waite reduction by pi/2 in three parts, then minimax polynomials on [-pi/4, pi/4].
inline SinCos sin_cos(float x) {
  if (!(x * x <= kMaxAngle * kMaxAngle)) [[unlikely]] {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    return {nan, nan};
  }
  constexpr float kShift = 8192.0F;  // a multiple of 4 above the most quarter turns
  const auto quadrant = static_cast<std::int32_t>(x * 0.636619772367581F + (kShift + 0.5F));
  const float n = static_cast<float>(quadrant) - kShift;
  const float r = ((x - n * 1.5703125F) - n * 4.837512969970703125e-4F) - n * 7.54978995489188216e-8F;
  const float z = r * r;
  const float s = ((-1.9515295891e-4F * z + 8.3321608736e-3F) * z - 1.6666654611e-1F) * z * r + r;
  const float c =
      ((2.443315711809948e-5F * z - 1.388731625493765e-3F) * z + 4.166664568298827e-2F) * z * z - 0.5F * z + 1.0F;
  const bool swap = (quadrant & 1) != 0;
  const float sine = swap ? c : s;
  const float cosine = swap ? s : c;
  return {(quadrant & 2) != 0 ? -sine : sine, ((quadrant + 1) & 2) != 0 ? -cosine : cosine};
}

inline constexpr float kSmallAngle = 0.7F;

// Sine and cosine of a small angle, or of one a lane, error below 1.1e-7 for |x| <= kSmallAngle: the first terms of
// their series, the last two adjusted to the range.
template <class Real>
inline SinCosOf<Real> small_sin_cos(Real x) {
  const Real z = x * x;
  const Real sine = x + x * (z * (-1.0F / 6.0F + z * (8.332922294e-3F - z * 1.962487165e-4F)));
  return {sine, 1.0F + z * (-0.5F + z * (4.166325879e-2F - z * 1.370074570e-3F))};
}

// Sine and cosine of the sum and of the difference of two angles.
inline SinCos operator+(SinCos a, SinCos b) {
  return {a.sin * b.cos + product(a.cos, b.sin), a.cos * b.cos - product(a.sin, b.sin)};
}
inline SinCos operator-(SinCos a, SinCos b) {
  return {a.sin * b.cos - product(a.cos, b.sin), a.cos * b.cos + product(a.sin, b.sin)};
}

// A frame in the plane: where its origin lies, and the direction of its x axis.
struct Pose {
  Vec2 position;
  SinCos heading;
};

// Turns `count` frames to as many angles: sin_cos of each, bit for bit, several at a time where the processor can.
void turn_to(const float* angles, int count, Pose* frames);

// Angle of the vector (x, y) in [-pi, pi], error below 4e-7; 0 for the zero vector.
float atan2(float y, float x);

// The angle between two directions, in [0, pi].
inline float angle_between(SinCos a, SinCos b) {
  const SinCos apart = a - b;
  return absolute(atan2(apart.sin, apart.cos));
}

// Natural logarithm of a positive normal number, error below 2 units in the last place near 1 and 3e-7 relative
// elsewhere; -infinity for 0 and below, NaN for NaN.
float log(float x);

// The same direction in [-pi, pi]; for |x| <= kMaxAngle.
float wrap_angle(float x);

}  // namespace krait
