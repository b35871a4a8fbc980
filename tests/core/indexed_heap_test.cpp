// Dijkstra's queue against an ordered set in random sequences of its operations.
#include "krait/decomposition/indexed_heap.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>
#include <vector>

#include "draws.hpp"

namespace krait::test {
namespace {

struct Fixture {
  explicit Fixture(Index capacity) : items(capacity), places(capacity), keys(capacity) {
    heap.assign(items.data(), places.data(), keys.data(), capacity);
    heap.reset();
  }
  std::vector<Index> items, places;
  std::vector<float> keys;
  IndexedHeap heap;
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

TEST(IndexedHeap, InfiniteKeysComeLast) {
  Fixture f(3);
  f.keys = {std::numeric_limits<float>::infinity(), 1e30F, 0.0F};
  for (Index i = 0; i < 3; ++i) f.heap.push(i);
  EXPECT_EQ(f.heap.pop(), 2U);
  EXPECT_EQ(f.heap.pop(), 1U);
  EXPECT_EQ(f.heap.pop(), 0U);
}

}  // namespace
}  // namespace krait::test
