// SPDX-License-Identifier: Apache-2.0
// The code for four and for eight lanes against the scalar code, whichever of them the library takes on this machine.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "base/lanes/kernels.hpp"
#include "draws.hpp"

#ifndef KRAIT_LANES

TEST(Lanes, AreNotOfThisProcessor) { GTEST_SKIP() << "only the scalar code runs here"; }

#else

namespace krait::test::lanes_test {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

struct Way {
  const char* name;
  int least;  // angles
  void (*turn_frames)(const float*, int, Pose*);
  void (*turn_hitches)(const detail::lanes::NearHitches&, float*, float*);
};

std::vector<Way> ways() {
  std::vector<Way> found{{"four lanes", 4, detail::lanes::turn_frames_by<4>, detail::lanes::turn_hitches_by<4>},
                         {"the library's choice", 4, detail::lanes::turn_frames, detail::lanes::turn_hitches}};
#ifdef KRAIT_AVX2
  if (__builtin_cpu_supports("avx2")) {
    found.push_back({"eight lanes", 8, detail::lanes::avx2::turn_frames, detail::lanes::avx2::turn_hitches});
  }
#endif
  return found;
}

std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }

// Of NaN only that it is one: IEEE-754 leaves its bits open.
bool same(float a, float b) { return a != a ? b != b : bits(a) == bits(b); }
bool same(SinCos a, SinCos b) { return same(a.sin, b.sin) && same(a.cos, b.cos); }

// Two of them differ by no more than kSmallAngle.
float half_of_small(std::mt19937& random) { return uniform_float(random, -0.35, 0.35); }

std::vector<float> draw(std::mt19937& random, int count, double most) {
  std::vector<float> drawn;
  for (int i = 0; i < count; ++i) drawn.push_back(uniform_float(random, -most, most));
  return drawn;
}

void expect_frames_as_scalar(const Way& way, const std::vector<float>& angles) {
  const Pose untouched{{5.0F, 6.0F}, {7.0F, 7.0F}};
  std::vector<Pose> frames(angles.size() + 1, untouched);
  way.turn_frames(angles.data(), static_cast<int>(angles.size()), frames.data());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    ASSERT_TRUE(same(frames[i].heading, math::sin_cos(angles[i]))) << way.name << ": " << angles[i];
    ASSERT_EQ(frames[i].position.x, 5.0F) << way.name;
  }
  ASSERT_EQ(frames.back().heading.sin, 7.0F) << way.name << " wrote beyond the last";
}

TEST(Lanes, FramesTurnAsByTheScalarCode) {
  std::mt19937 random(3);
  for (const Way& way : ways()) {
    for (int count = way.least; count < 40; ++count) {
      for (const double most : {1e-3, 8.0, double{kMaxAngle}}) {
        for (int trial = 0; trial < 50; ++trial) expect_frames_as_scalar(way, draw(random, count, most));
      }
    }
  }
}

TEST(Lanes, AnAngleOutOfRangeTouchesNoOther) {
  for (const Way& way : ways()) {
    for (int count = way.least; count < 18; ++count) {
      for (std::size_t place = 0; place < static_cast<std::size_t>(count); ++place) {
        for (const float x : {kNan, kInfinity, -kInfinity, std::nextafter(kMaxAngle, 1e9F), -3e38F, -0.0F, 1e-40F}) {
          std::vector<float> angles(static_cast<std::size_t>(count), 1.25F);
          angles[place] = x;
          expect_frames_as_scalar(way, angles);
        }
      }
    }
  }
}

TEST(Lanes, HitchesTurnAsByTheScalarCode) {
  std::mt19937 random(4);
  for (const Way& way : ways()) {
    for (int trailers = way.least; trailers <= 25; ++trailers) {
      const auto count = static_cast<std::size_t>(trailers);
      for (int trial = 0; trial < 200; ++trial) {
        std::vector<float> turned;
        for (int i = 0; i <= trailers; ++i) turned.push_back(half_of_small(random));
        std::vector<SinCos> hitches;
        std::vector<float> known_sines, known_cosines;
        for (const float hitch : draw(random, trailers, 1.5)) {
          hitches.push_back(math::sin_cos(hitch));
          known_sines.push_back(hitches.back().sin);
          known_cosines.push_back(hitches.back().cos);
        }
        std::vector<float> sines(count + 1, 7.0F), cosines(count + 1, 7.0F);
        way.turn_hitches({trailers, turned.data(), known_sines.data(), known_cosines.data()}, sines.data(),
                         cosines.data());
        for (std::size_t i = 0; i < count; ++i) {
          const SinCos expected = hitches[i] + math::small_sin_cos(turned[i] - turned[i + 1]);
          ASSERT_TRUE(same({sines[i], cosines[i]}, expected)) << way.name << ": trailer " << i << " of " << count;
        }
        ASSERT_EQ(sines[count], 7.0F) << way.name << " wrote beyond the last";
        ASSERT_EQ(cosines[count], 7.0F) << way.name << " wrote beyond the last";
      }
    }
  }
}

template <int n>
void expect_blocks_cover() {
  for (int count = n; count < 40; ++count) {
    std::vector<int> covered(static_cast<std::size_t>(count), 0);
    detail::for_each_block<n>(count, [&](int first) {
      ASSERT_GE(first, 0);
      ASSERT_LE(first + n, count);
      for (int i = first; i < first + n; ++i) ++covered[static_cast<std::size_t>(i)];
    });
    for (const int times : covered) ASSERT_TRUE(times == 1 || times == 2) << count;
  }
}

TEST(Lanes, BlocksCoverEveryCountAndNoMore) {
  expect_blocks_cover<4>();
  expect_blocks_cover<8>();
}

}  // namespace
}  // namespace krait::test::lanes_test

#endif
