// SPDX-License-Identifier: Apache-2.0
// A binary heap of region numbers ordered by (key, number), with decrease-key: Dijkstra's queue.
#pragma once

#include "base/packed_indices.hpp"
#include "krait/status.hpp"

namespace krait::detail {

// `keys` is the caller's array that orders the numbers and is changed by the caller before each push. All numbers start
// absent (reset).
class IndexedHeap {
 public:
  // Allocates room for the numbers below `capacity`: 4 or 8 bytes each.
  void allocate(Arena& arena, Pool pool, const float* keys, Index capacity) {
    heap_.allocate(arena, pool, capacity, capacity);
    place_.allocate(arena, pool, capacity, capacity);
    keys_ = keys;
    capacity_ = capacity;
  }

  // O(capacity).
  void reset() {
    size_ = 0;
    for (Index i = 0; i < capacity_; ++i) place_.set(i, kNone);
  }

  // The queue's memory as a plain list of `capacity` numbers, while it is empty. Pushing the list's numbers one by one,
  // front to back, overwrites none that is still to come.
  Index listed(Index i) const {
    KRAIT_ASSERT(i >= size_ && i < capacity_);
    return heap_[i];
  }
  void list(Index i, Index number) {
    KRAIT_ASSERT(empty() && i < capacity_);
    heap_.set(i, number);
  }

  bool empty() const { return size_ == 0; }

  // Inserts `number`, or moves it up after its key fell. O(log n).
  void push(Index number) {
    KRAIT_ASSERT(number < capacity_);
    Index hole = place_[number];
    if (hole == kNone) hole = size_++;
    while (hole > 0) {
      const Index parent = (hole - 1) / 2;
      if (!before(number, heap_[parent])) break;
      put(heap_[parent], hole);
      hole = parent;
    }
    put(number, hole);
  }

  // Removes and returns the number with the smallest (key, number). Not empty. O(log n).
  Index pop() {
    KRAIT_ASSERT(!empty());
    const Index top = heap_[0];
    place_.set(top, kNone);
    const Index last = heap_[--size_];
    if (size_ == 0) return top;
    Index hole = 0;
    for (Index child = 1; child < size_; child = 2 * hole + 1) {
      if (child + 1 < size_ && before(heap_[child + 1], heap_[child])) ++child;
      if (!before(heap_[child], last)) break;
      put(heap_[child], hole);
      hole = child;
    }
    put(last, hole);
    return top;
  }

 private:
  bool before(Index a, Index b) const { return keys_[a] < keys_[b] || (keys_[a] == keys_[b] && a < b); }
  void put(Index number, Index hole) {
    heap_.set(hole, number);
    place_.set(number, hole);
  }

  PackedIndices heap_;
  PackedIndices place_;
  const float* keys_ = nullptr;
  Index capacity_ = 0;
  Index size_ = 0;
};

}  // namespace krait::detail
