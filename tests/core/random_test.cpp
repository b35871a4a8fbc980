// SPDX-License-Identifier: Apache-2.0
// The generator against the published algorithms, and the uniformity of what is drawn from it.
#include "base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace krait::test::random_test {
namespace {

// Blackman and Vigna's xoshiro128++ seeded by Vigna's splitmix64, written from their descriptions.
class Published {
 public:
  explicit Published(std::uint64_t seed) {
    const std::uint64_t first = splitmix(seed), second = splitmix(seed);
    s_[0] = static_cast<std::uint32_t>(first & 0xFFFFFFFFULL);
    s_[1] = static_cast<std::uint32_t>(first >> 32);
    s_[2] = static_cast<std::uint32_t>(second & 0xFFFFFFFFULL);
    s_[3] = static_cast<std::uint32_t>(second >> 32);
  }
  std::uint32_t next() {
    const std::uint32_t sum = s_[0] + s_[3];
    const std::uint32_t out = ((sum << 7) | (sum >> 25)) + s_[0];
    const std::uint32_t shifted = s_[1] << 9;
    s_[2] ^= s_[0];
    s_[3] ^= s_[1];
    s_[1] ^= s_[2];
    s_[0] ^= s_[3];
    s_[2] ^= shifted;
    s_[3] = (s_[3] << 11) | (s_[3] >> 21);
    return out;
  }

  static std::uint64_t splitmix(std::uint64_t& x) {
    std::uint64_t z = (x += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

 private:
  std::uint32_t s_[4];
};

// Chi-square statistic of counts that should be equal, in standard deviations from its mean.
double surprise(const std::vector<int>& counts) {
  double total = 0;
  for (const int c : counts) total += c;
  const double expected = total / static_cast<double>(counts.size());
  double chi_square = 0;
  for (const int c : counts) chi_square += (c - expected) * (c - expected) / expected;
  const double freedom = static_cast<double>(counts.size()) - 1;
  return (chi_square - freedom) / std::sqrt(2 * freedom);
}

TEST(Random, SplitMixGivesItsPublishedFirstValue) {
  std::uint64_t seed = 1234567;
  EXPECT_EQ(Published::splitmix(seed), 6457827717110365317ULL);
}

TEST(Random, BitsAreThePublishedSequence) {
  for (const std::uint64_t seed : {0ULL, 1ULL, 2ULL, 0xFFFFFFFFFFFFFFFFULL, 20150907ULL}) {
    detail::Random random(seed);
    Published published(seed);
    for (int i = 0; i < 10'000; ++i) ASSERT_EQ(random.bits(), published.next()) << seed << " " << i;
  }
}

TEST(Random, SeedOneIsTheDefault) {
  detail::Random a, b(1);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(a.bits(), b.bits());
}

TEST(Random, DifferentSeedsDiffer) {
  detail::Random a(1), b(2);
  int equal = 0;
  for (int i = 0; i < 1000; ++i) equal += a.bits() == b.bits() ? 1 : 0;
  EXPECT_LE(equal, 1);
}

TEST(Random, BelowIsUniform) {
  for (const std::uint32_t sides : {2U, 3U, 7U, 10U, 100U}) {
    detail::Random random(sides);
    std::vector<int> counts(sides);
    for (int i = 0; i < 200'000; ++i) {
      const std::uint32_t value = random.below(sides);
      ASSERT_LT(value, sides);
      ++counts[value];
    }
    EXPECT_LT(std::abs(surprise(counts)), 5) << sides;
  }
}

TEST(Random, BelowOneIsZero) {
  detail::Random random;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(random.below(1), 0U);
}

TEST(Random, BelowReachesBothEndsOfALargeRange) {
  detail::Random random;
  std::uint32_t least = 0xFFFFFFFF, most = 0;
  for (int i = 0; i < 10'000; ++i) {
    const std::uint32_t value = random.below(0xFFFFFFFF);
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_LT(least, 0x00400000U);
  EXPECT_GT(most, 0xFFC00000U);
}

TEST(Random, UnitIsUniformOnMultiplesOf24BitsBelowOne) {
  detail::Random random(5);
  std::vector<int> counts(64);
  for (int i = 0; i < 500'000; ++i) {
    const float value = random.unit();
    ASSERT_GE(value, 0.0F);
    ASSERT_LT(value, 1.0F);
    const float scaled = value * 0x1p24F;
    ASSERT_EQ(scaled, std::floor(scaled));
    ++counts[static_cast<std::size_t>(value * 64)];
  }
  EXPECT_LT(std::abs(surprise(counts)), 5);
}

TEST(Random, ConsecutivePairsAreUniform) {
  detail::Random random(6);
  std::vector<int> counts(256);
  for (int i = 0; i < 500'000; ++i) {
    const std::uint32_t first = random.below(16);
    const std::uint32_t second = random.below(16);
    ++counts[first * 16 + second];
  }
  EXPECT_LT(std::abs(surprise(counts)), 5);
}

}  // namespace
}  // namespace krait::test::random_test
