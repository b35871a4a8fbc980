// SPDX-License-Identifier: Apache-2.0
// The block cut into pools: what it counts is what it takes.
#include "base/arena.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace krait::test::arena_test {
namespace {

struct Twelve {
  float values[3];
};

// Allocates arrays of several types; returns their addresses.
std::vector<const void*> take_all(detail::Arena& arena) {
  return {arena.allocate<std::uint8_t>(detail::Pool::regions, 3),
          arena.allocate<std::uint64_t>(detail::Pool::states, 2), arena.allocate<Twelve>(detail::Pool::states, 5),
          arena.allocate<std::uint16_t>(detail::Pool::members, 1), arena.allocate<float>(detail::Pool::expansions, 0)};
}

TEST(Arena, CountsWhatItLaterTakes) {
  detail::Arena counting;
  for (const void* pointer : take_all(counting)) EXPECT_EQ(pointer, nullptr);
  std::vector<std::uint64_t> block(counting.needed() / 8);
  detail::Arena arena(block.data(), block.size() * 8);
  take_all(arena);
  EXPECT_EQ(arena.needed(), counting.needed());
  EXPECT_TRUE(arena.fits());
  EXPECT_FALSE(counting.fits());
}

TEST(Arena, NeedsEachTakeRoundedUpToTheAlignment) {
  detail::Arena arena;
  take_all(arena);
  EXPECT_EQ(arena.needed(), 8U + 16U + 64U + 8U + 0U);
}

TEST(Arena, PoolsAddUpToTheWhole) {
  detail::Arena arena;
  take_all(arena);
  EXPECT_EQ(arena.needed(detail::Pool::regions), 8U);
  EXPECT_EQ(arena.needed(detail::Pool::states), 80U);
  EXPECT_EQ(arena.needed(detail::Pool::members), 8U);
  EXPECT_EQ(arena.needed(detail::Pool::portals), 0U);
  std::uint64_t sum = 0;
  for (std::size_t pool = 0; pool < detail::kPoolCount; ++pool) sum += arena.needed(static_cast<detail::Pool>(pool));
  EXPECT_EQ(sum, arena.needed());
}

TEST(Arena, EveryTakeIsAlignedInsideTheBlockAndApartFromTheOthers) {
  std::vector<std::uint64_t> block(12);
  detail::Arena arena(block.data(), 96);
  const auto taken = take_all(arena);
  const auto start = reinterpret_cast<std::uintptr_t>(block.data());
  const std::array<std::uintptr_t, 5> expected = {0, 8, 24, 88, 96};
  for (std::size_t i = 0; i < taken.size(); ++i) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(taken[i]) - start, expected[i]) << i;
  }
}

TEST(Arena, OneByteLessGivesNullForWhatNoLongerFits) {
  std::vector<std::uint64_t> block(12);
  detail::Arena arena(block.data(), 95);
  const auto taken = take_all(arena);
  EXPECT_NE(taken[2], nullptr);
  EXPECT_EQ(taken[3], nullptr);
  EXPECT_FALSE(arena.fits());
  EXPECT_EQ(arena.needed(), 96U);
}

TEST(Arena, SizesBeyond32BitsAreCounted) {
  detail::Arena arena;
  arena.allocate<std::uint64_t>(detail::Pool::states, 1U << 31U, 1U << 9U);
  EXPECT_EQ(arena.needed(), std::uint64_t{1} << 43U);
}

TEST(Arena, PaddingDoesNotDependOnTheAddress) {
  std::vector<std::uint64_t> block(64);
  for (std::size_t shift = 0; shift < 8; ++shift) {
    detail::Arena arena(block.data() + shift, 256);
    take_all(arena);
    EXPECT_EQ(arena.needed(), 96U);
  }
}

TEST(Arena, PoolsHaveNames) {
  EXPECT_STREQ(to_string(detail::Pool::regions), "regions");
  EXPECT_STREQ(to_string(detail::Pool::members), "members");
}

}  // namespace
}  // namespace krait::test::arena_test
