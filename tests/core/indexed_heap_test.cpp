// SPDX-License-Identifier: Apache-2.0
// Dijkstra's queue against an ordered set in random sequences of its operations.
#include "decomposition/indexed_heap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "draws.hpp"

namespace krait::test::indexed_heap_test {
namespace {

struct Fixture {
  explicit Fixture(Index capacity) : keys(capacity) {
    detail::Arena counting;
    heap.allocate(counting, detail::Pool::regions, keys.data(), capacity);
    block.resize(counting.needed() / 8);
    detail::Arena arena(block.data(), block.size() * 8);
    heap.allocate(arena, detail::Pool::regions, keys.data(), capacity);
    heap.reset();
  }
  std::vector<std::uint64_t> block;
  std::vector<float> keys;
  detail::IndexedHeap heap;
};

TEST(IndexedHeap, AgreesWithAnOrderedSet) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    const Index capacity = 1 + below(random, 300);
    Fixture f(capacity);
    std::set<std::pair<float, Index>> expected;
    for (int i = 0; i < 20'000; ++i) {
      const Index number = below(random, capacity);
      const bool present = expected.count({f.keys[number], number}) != 0;
      if (random() % 3 == 0 && !expected.empty()) {
        ASSERT_EQ(f.heap.pop(), expected.begin()->second);
        expected.erase(expected.begin());
      } else if (!present) {
        f.keys[number] = static_cast<float>(random() % 64);  // many ties
        f.heap.push(number);
        expected.insert({f.keys[number], number});
      } else {
        expected.erase({f.keys[number], number});
        f.keys[number] -= static_cast<float>(random() % 8);
        f.heap.push(number);
        expected.insert({f.keys[number], number});
      }
      ASSERT_EQ(f.heap.empty(), expected.empty());
    }
  }
}

TEST(IndexedHeap, EqualKeysComeInTheOrderOfTheirNumbers) {
  Fixture f(100);
  for (Index i = 100; i > 0; --i) f.heap.push(i - 1);
  for (Index i = 0; i < 100; ++i) ASSERT_EQ(f.heap.pop(), i);
  EXPECT_TRUE(f.heap.empty());
}

TEST(IndexedHeap, ResetEmptiesIt) {
  Fixture f(10);
  f.keys[3] = 5;
  f.heap.push(3);
  f.heap.push(4);
  f.heap.reset();
  EXPECT_TRUE(f.heap.empty());
  f.keys[3] = 7;
  f.heap.push(3);
  EXPECT_EQ(f.heap.pop(), 3U);
  EXPECT_TRUE(f.heap.empty());
}

// What a repair of the shortest paths does with it: a list, then a queue in the same memory.
TEST(IndexedHeap, PushingItsOwnListFrontToBackLosesNone) {
  std::mt19937 random(4);
  for (int round = 0; round < 200; ++round) {
    const Index capacity = 1 + below(random, 300);
    Fixture f(capacity);
    std::vector<Index> numbers(capacity);
    std::iota(numbers.begin(), numbers.end(), 0U);
    std::shuffle(numbers.begin(), numbers.end(), random);
    std::set<std::pair<float, Index>> expected;
    const Index count = 1 + below(random, capacity);
    for (Index i = 0; i < count; ++i) f.heap.list(i, numbers[i]);
    for (Index i = 0; i < count; ++i) {
      const Index number = f.heap.listed(i);
      ASSERT_EQ(number, numbers[i]);
      if (random() % 4 == 0) continue;  // some are not queued
      f.keys[number] = static_cast<float>(random() % 64);
      f.heap.push(number);
      expected.insert({f.keys[number], number});
    }
    for (const auto& [key, number] : expected) ASSERT_EQ(f.heap.pop(), number);
    ASSERT_TRUE(f.heap.empty());
  }
}

TEST(IndexedHeap, NumbersBeyond16BitsAreOrderedAsWell) {
  Fixture f(200'000);
  for (const Index number : {199'999U, 65'535U, 65'534U, 65'536U, 0U, 131'071U}) f.heap.push(number);
  for (const Index number : {0U, 65'534U, 65'535U, 65'536U, 131'071U, 199'999U}) ASSERT_EQ(f.heap.pop(), number);
}

TEST(IndexedHeap, InfiniteKeysComeLast) {
  Fixture f(3);
  f.keys = {std::numeric_limits<float>::infinity(), 1e30F, 0.0F};
  for (Index i = 0; i < 3; ++i) f.heap.push(i);
  EXPECT_EQ(f.heap.pop(), 2U);
  EXPECT_EQ(f.heap.pop(), 1U);
  EXPECT_EQ(f.heap.pop(), 0U);
}

}  // namespace
}  // namespace krait::test::indexed_heap_test
