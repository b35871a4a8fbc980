// SPDX-License-Identifier: Apache-2.0
// The core's own functions against libm in double precision, within the errors that their comments promise.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "krait/geometry.hpp"

namespace krait::test::math_test {
namespace {

constexpr double kTrueAngle = 3.14159265358979323846;
const float kNan = std::numeric_limits<float>::quiet_NaN();

double wide(float x) { return static_cast<double>(x); }

// Calls check(x) for a dense sweep of [low, high].
template <class Check>
void sweep(float low, float high, int count, Check check) {
  for (int i = 0; i <= count; ++i) {
    check(static_cast<float>(wide(low) + (wide(high) - wide(low)) * i / count));
  }
}

TEST(Math, SineAndCosineWithin8e8) {
  double worst = 0;
  const auto check = [&](float x) {
    const SinCos got = math::sin_cos(x);
    worst = std::max(worst, std::abs(wide(got.sin) - std::sin(wide(x))));
    worst = std::max(worst, std::abs(wide(got.cos) - std::cos(wide(x))));
  };
  sweep(-8.0F, 8.0F, 400'000, check);
  sweep(-kMaxAngle, kMaxAngle, 1'000'000, check);
  for (int i = -5215; i <= 5215; ++i) {  // around the multiples of pi/2, where the reduction is hardest
    float x = static_cast<float>(i * kTrueAngle / 2);
    for (int step = 0; step < 3; ++step, x = std::nextafter(x, 1e9F)) check(x);
  }
  EXPECT_LT(worst, 8e-8);
  RecordProperty("worst", std::to_string(worst));
}

TEST(Math, SineAndCosineOfZeroAreExact) {
  EXPECT_EQ(math::sin_cos(0.0F).sin, 0.0F);
  EXPECT_EQ(math::sin_cos(0.0F).cos, 1.0F);
}

TEST(Math, SineAndCosineNeverExceedOneByMoreThanAnUlp) {
  sweep(-kMaxAngle, kMaxAngle, 500'000, [](float x) {
    ASSERT_LE(std::abs(math::sin_cos(x).sin), 1.0F + 1.2e-7F) << x;
    ASSERT_LE(std::abs(math::sin_cos(x).cos), 1.0F + 1.2e-7F) << x;
  });
}

TEST(Math, SineAndCosineRefuseWhatIsOutOfRange) {
  for (const float x : {kNan, kInfinity, -kInfinity, std::nextafter(kMaxAngle, 1e9F), -1e30F, 3e38F}) {
    EXPECT_TRUE(std::isnan(math::sin_cos(x).sin)) << x;
    EXPECT_TRUE(std::isnan(math::sin_cos(x).cos)) << x;
  }
  EXPECT_FALSE(std::isnan(math::sin_cos(kMaxAngle).sin));
  EXPECT_FALSE(std::isnan(math::sin_cos(-kMaxAngle).cos));
}

std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }

// turn_to is the scalar sin_cos in every bit. Of NaN only that it is one: IEEE-754 leaves its bits open.
void expect_as_scalar(const std::vector<float>& angles) {
  const std::size_t count = angles.size();
  const Pose untouched{{5.0F, 6.0F}, {7.0F, 7.0F}};
  std::vector<Pose> frames(count + 1, untouched);
  turn_to(angles.data(), static_cast<int>(count), frames.data());
  for (std::size_t i = 0; i < count; ++i) {
    const SinCos got = frames[i].heading, expected = math::sin_cos(angles[i]);
    ASSERT_EQ(frames[i].position.x, 5.0F);
    ASSERT_EQ(frames[i].position.y, 6.0F);
    if (expected.sin != expected.sin) {
      ASSERT_TRUE(std::isnan(got.sin) && std::isnan(got.cos)) << angles[i];
      continue;
    }
    ASSERT_EQ(bits(got.sin), bits(expected.sin)) << angles[i];
    ASSERT_EQ(bits(got.cos), bits(expected.cos)) << angles[i];
  }
  ASSERT_EQ(frames[count].heading.sin, 7.0F);  // and nothing beyond
}

TEST(MathArrays, SinesAndCosinesAreTheScalarOnesBitForBit) {
  std::vector<float> angles;
  const auto add = [&](float x) { angles.push_back(x); };
  sweep(-8.0F, 8.0F, 400'000, add);
  sweep(-kMaxAngle, kMaxAngle, 1'000'000, add);
  sweep(-1e-3F, 1e-3F, 10'000, add);
  for (int i = -5215; i <= 5215; ++i) {
    float x = static_cast<float>(i * kTrueAngle / 4);  // where the quadrant changes, and the multiples of pi/2
    for (int step = 0; step < 3; ++step, x = std::nextafter(x, 1e9F)) add(x);
  }
  for (std::uint32_t pattern = 0; pattern < 0xFFFF0000U; pattern += 65'521) add(std::bit_cast<float>(pattern));
  expect_as_scalar(angles);
}

TEST(MathArrays, OfEveryCountAndAtEveryPlace) {
  std::mt19937 random(5);
  for (std::size_t count = 0; count <= 27; ++count) {
    for (int trial = 0; trial < 200; ++trial) {
      std::vector<float> angles;
      for (std::size_t i = 0; i < count; ++i) {
        angles.push_back(16.0F * static_cast<float>(static_cast<double>(random()) / 4294967296.0 - 0.5));
      }
      expect_as_scalar(angles);
    }
  }
}

// A lane that is out of range must not touch the others.
TEST(MathArrays, LanesOutOfRangeAreNanAndOthersAreNot) {
  const float strange[] = {kNan,  -kNan, kInfinity, -kInfinity, 1e30F,      -1e30F, std::nextafter(kMaxAngle, 1e9F),
                           3e38F, -0.0F, 1e-40F,    kMaxAngle,  -kMaxAngle, 2.1e9F, -2.2e9F};
  for (std::size_t count = 1; count <= 9; ++count) {
    for (std::size_t place = 0; place < count; ++place) {
      for (const float x : strange) {
        std::vector<float> angles(count, 1.25F);
        angles[place] = x;
        expect_as_scalar(angles);
      }
    }
  }
}

TEST(Math, SmallSineAndCosineWithin1p1e7) {
  sweep(-kSmallAngle, kSmallAngle, 500'000, [](float x) {
    ASSERT_LT(std::abs(wide(math::small_sin_cos(x).sin) - std::sin(wide(x))), 1.1e-7) << x;
    ASSERT_LT(std::abs(wide(math::small_sin_cos(x).cos) - std::cos(wide(x))), 1.1e-7) << x;
  });
}

TEST(Math, Atan2Within4e7OnEveryScale) {
  double worst = 0;
  for (const float scale : {1e-30F, 1e-3F, 1.0F, 1e5F, 1e30F}) {
    sweep(-3.1415926F, 3.1415926F, 200'000, [&](float angle) {
      const float y = scale * static_cast<float>(std::sin(wide(angle)));
      const float x = scale * static_cast<float>(std::cos(wide(angle)));
      worst = std::max(worst, std::abs(wide(math::atan2(y, x)) - std::atan2(wide(y), wide(x))));
    });
  }
  EXPECT_LT(worst, 4e-7);
}

TEST(Math, Atan2OnTheAxes) {
  EXPECT_EQ(math::atan2(0.0F, 0.0F), 0.0F);
  EXPECT_EQ(math::atan2(0.0F, 1.0F), 0.0F);
  EXPECT_EQ(math::atan2(1.0F, 0.0F), kPi / 2.0F);
  EXPECT_EQ(math::atan2(-1.0F, 0.0F), -kPi / 2.0F);
  EXPECT_EQ(math::atan2(0.0F, -1.0F), kPi);
  EXPECT_TRUE(std::isnan(math::atan2(kNan, 1.0F)));
  EXPECT_TRUE(std::isnan(math::atan2(1.0F, kNan)));
}

TEST(Math, Atan2StaysInItsRange) {
  std::mt19937 random(3);
  for (int i = 0; i < 200'000; ++i) {
    const float y = static_cast<float>(random()) - 2147483648.0F;
    const float x = static_cast<float>(random()) - 2147483648.0F;
    ASSERT_LE(std::abs(math::atan2(y, x)), kPi);
  }
}

TEST(Math, LogarithmWithin2UlpsNearOneAnd3e7RelativeElsewhere) {
  double worst = 0;
  for (std::uint32_t bits = 0x00800000U; bits < 0x7F800000U; bits += 1237) {  // every normal exponent
    const float x = std::bit_cast<float>(bits);
    const double exact = std::log(wide(x));
    if (std::abs(exact) > 0.5) worst = std::max(worst, std::abs(wide(math::log(x)) - exact) / std::abs(exact));
  }
  EXPECT_LT(worst, 3e-7);
  worst = 0;
  for (std::uint32_t bits = std::bit_cast<std::uint32_t>(0.61F); bits < std::bit_cast<std::uint32_t>(1.64F);
       bits += 5) {
    const float x = std::bit_cast<float>(bits);
    const double exact = std::log(wide(x));
    const auto rounded = static_cast<float>(exact);
    const double ulp = wide(std::nextafter(std::abs(rounded), kInfinity)) - wide(std::abs(rounded));
    if (x != 1.0F) worst = std::max(worst, std::abs(wide(math::log(x)) - exact) / ulp);
  }
  EXPECT_LT(worst, 2.0);
}

TEST(Math, LogarithmAtTheEdges) {
  EXPECT_EQ(math::log(1.0F), 0.0F);
  EXPECT_EQ(math::log(0.0F), -kInfinity);
  EXPECT_EQ(math::log(-0.0F), -kInfinity);
  EXPECT_EQ(math::log(-1.0F), -kInfinity);
  EXPECT_EQ(math::log(-kInfinity), -kInfinity);
  EXPECT_EQ(math::log(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(math::log(kNan)));
}

TEST(Math, LogarithmRisesWithItsArgument) {
  float last = -kInfinity;
  for (std::uint32_t bits = 0x00800000U; bits < 0x7F800000U; bits += 40961) {
    const float value = math::log(std::bit_cast<float>(bits));
    ASSERT_GE(value, last);
    last = value;
  }
}

TEST(Math, WrappedAngleHasTheSameDirectionAndLiesInRange) {
  double worst = 0;
  float largest = 0;
  const auto check = [&](float x) {
    const float w = math::wrap_angle(x);
    largest = std::max(largest, std::abs(w));
    worst = std::max(worst, std::abs(std::remainder(wide(w) - wide(x), 2 * kTrueAngle)));
  };
  sweep(-kMaxAngle, kMaxAngle, 1'000'000, check);
  for (int i = -2607; i <= 2607; ++i) {  // around the odd multiples of pi, where it jumps
    float x = static_cast<float>(i * kTrueAngle);
    x = std::nextafter(std::nextafter(x, -1e9F), -1e9F);
    for (int step = 0; step < 5; ++step, x = std::nextafter(x, 1e9F)) check(x);
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_LE(wide(largest), kTrueAngle + 5e-4);  // of an angle near 8192, whose own spacing is that wide
}

TEST(Math, WrappedSmallAnglesAreUnchanged) {
  sweep(-3.14F, 3.14F, 10'000, [](float x) { ASSERT_EQ(math::wrap_angle(x), x); });
}

TEST(Math, WrappedAngleRefusesWhatIsOutOfRange) {
  for (const float x : {kNan, kInfinity, -kInfinity, 1e30F}) EXPECT_TRUE(std::isnan(math::wrap_angle(x))) << x;
}

TEST(Math, FiniteIsFalseForNanAndInfinity) {
  EXPECT_TRUE(finite(0.0F));
  EXPECT_TRUE(finite(3.4e38F));
  EXPECT_FALSE(finite(kNan));
  EXPECT_FALSE(finite(kInfinity));
  EXPECT_FALSE(finite(Vec2{0.0F, -kInfinity}));
}

TEST(Math, ClampTurnsNanIntoTheLowerEnd) {
  EXPECT_EQ(math::clamp(kNan, -1.0F, 1.0F), -1.0F);
  EXPECT_EQ(math::clamp(2.0F, -1.0F, 1.0F), 1.0F);
  EXPECT_EQ(math::clamp(-2.0F, -1.0F, 1.0F), -1.0F);
  EXPECT_EQ(math::clamp(0.25F, -1.0F, 1.0F), 0.25F);
}

}  // namespace
}  // namespace krait::test::math_test
