// SPDX-License-Identifier: Apache-2.0
#include "krait/math.hpp"

namespace krait::math {
namespace {

// atan on [0, tan(pi/8)] after reduction; polynomial in z = x*x (Cephes atanf coefficients).
float atan_unit(float x) {
  float offset = 0.0F;
  if (x > 0.4142135623731F) {  // tan(pi/8)
    offset = kPi / 4.0F;
    x = (x - 1.0F) / (x + 1.0F);
  }
  const float z = x * x;
  const float p =
      (((8.05374449538e-2F * z - 1.38776856032e-1F) * z + 1.99777106478e-1F) * z - 3.33329491539e-1F) * z * x + x;
  return offset + p;
}

}  // namespace

float atan2(float y, float x) {
  const float ax = x < 0.0F ? -x : x;
  const float ay = y < 0.0F ? -y : y;
  if (ax == 0.0F && ay == 0.0F) return 0.0F;
  const bool steep = ay > ax;
  float angle = steep ? kPi / 2.0F - atan_unit(ax / ay) : atan_unit(ay / ax);
  if (x < 0.0F) angle = kPi - angle;
  return y < 0.0F ? -angle : angle;
}

float log(float x) {
  if (!(x > 0.0F)) return x == x ? -kInfinity : x;
  if (x == kInfinity) return x;
  const auto bits = std::bit_cast<std::uint32_t>(x);
  auto exponent = static_cast<std::int32_t>(bits >> 23U) - 126;
  float m = std::bit_cast<float>((bits & 0x007FFFFFU) | 0x3F000000U);  // [0.5, 1)
  if (m < 0.707106781186547524F) {
    exponent -= 1;
    m = m + m - 1.0F;
  } else {
    m = m - 1.0F;
  }
  const float z = m * m;
  // Cephes logf coefficients.
  float y = 7.0376836292e-2F;
  y = y * m - 1.1514610310e-1F;
  y = y * m + 1.1676998740e-1F;
  y = y * m - 1.2420140846e-1F;
  y = y * m + 1.4249322787e-1F;
  y = y * m - 1.6668057665e-1F;
  y = y * m + 2.0000714765e-1F;
  y = y * m - 2.4999993993e-1F;
  y = y * m + 3.3333331174e-1F;
  y = y * m * z;
  const auto e = static_cast<float>(exponent);
  y = y + -2.12194440e-4F * e;
  y = y - 0.5F * z;
  return (m + y) + 0.693359375F * e;
}

float wrap_angle(float x) {
  const float turns = x * 0.159154943091895F;
  if (!(turns >= -kMaxAngle && turns <= kMaxAngle)) return std::numeric_limits<float>::quiet_NaN();
  const auto n = static_cast<float>(static_cast<std::int32_t>(turns + (turns >= 0.0F ? 0.5F : -0.5F)));
  return (x - n * 6.28125F) - n * 1.93530717958648e-3F;  // 2 pi in two parts, the first times n exact (Cody and Waite)
}

}  // namespace krait::math
