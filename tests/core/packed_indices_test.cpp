// SPDX-License-Identifier: Apache-2.0
// Indices of two or of four bytes: all of them, and kNone, are read back.
#include "base/packed_indices.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "draws.hpp"

namespace krait::test::packed_indices_test {
namespace {

struct Fixture {
  Fixture(std::uint32_t count, std::uint32_t limit) {
    detail::Arena counting;
    indices.allocate(counting, detail::Pool::regions, count, limit);
    bytes = counting.needed();
    block.resize(bytes / 8);
    detail::Arena arena(block.data(), bytes);
    indices.allocate(arena, detail::Pool::regions, count, limit);
  }
  std::uint64_t bytes;
  std::vector<std::uint64_t> block;
  detail::PackedIndices indices;
};

TEST(PackedIndices, TakeTwoBytesAsLongAsNoIndexIsTheMark) {
  EXPECT_EQ(Fixture(1000, 10).bytes, 2000U);
  EXPECT_EQ(Fixture(1000, 65'534).bytes, 2000U);
  EXPECT_EQ(Fixture(1000, 65'535).bytes, 2000U);  // the largest is 65,534
  EXPECT_EQ(Fixture(1000, 65'536).bytes, 4000U);
  EXPECT_EQ(Fixture(1000, 4'000'000'000U).bytes, 4000U);
  EXPECT_EQ(Fixture(0, 10).bytes, 0U);
}

TEST(PackedIndices, GiveBackWhatWasSetLast) {
  for (const std::uint32_t limit : {1U, 255U, 65'535U, 65'536U, 70'000U, 0xFFFFFFFFU}) {
    std::mt19937 random(limit);
    Fixture f(300, limit);
    std::vector<Index> expected(300);
    for (std::size_t i = 0; i < 300; ++i) f.indices.set(i, expected[i] = limit - 1);
    for (int step = 0; step < 3000; ++step) {
      const std::size_t i = below(random, 300);
      const Index index = random() % 4 == 0 ? kNone : random() % 4 == 0 ? limit - 1 : below(random, limit);
      f.indices.set(i, index);
      expected[i] = index;
      const std::size_t j = below(random, 300);
      ASSERT_EQ(f.indices[j], expected[j]) << limit;
    }
    for (std::size_t i = 0; i < 300; ++i) ASSERT_EQ(f.indices[i], expected[i]) << limit;
  }
}

}  // namespace
}  // namespace krait::test::packed_indices_test
