// SPDX-License-Identifier: Apache-2.0
// One block of the caller's memory, cut into pools front to back. Nothing is ever released.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "krait/status.hpp"

namespace krait::detail {

// What a pool holds.
enum class Pool : std::uint8_t {
  regions,
  portals,
  groups,
  vertices,
  states,
  expansions,
  members,
  improvement,
  work,  // arrays of the robot's sizes, by body and component
  count
};
inline constexpr std::size_t kPoolCount = static_cast<std::size_t>(Pool::count);

const char* to_string(Pool pool);

// Cuts a block into arrays. Without a block it only counts, so that the same code allocates the pools and
// counts the bytes that they need: the two cannot disagree.
class Arena {
 public:
  static constexpr std::size_t kAlignment = 8;  // of the block; padding does not depend on its address

  Arena() = default;

  // `block` must be aligned to kAlignment and outlive everything allocated from it.
  Arena(void* block, std::uint64_t bytes) : block_(static_cast<std::byte*>(block)), bytes_(bytes) {
    KRAIT_ASSERT(reinterpret_cast<std::uintptr_t>(block) % kAlignment == 0);
  }

  // Room for `count` rows of `width` objects, uninitialised; null while counting or when the block is too small. A row
  // has less than 4 GB. O(1).
  template <class T>
  T* allocate(Pool pool, std::uint32_t count, std::uint32_t width = 1) {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= kAlignment);
    return static_cast<T*>(allocate_rows(pool, count, width * sizeof(T)));
  }

  // Bytes that all arrays so far need, whether or not they fitted.
  std::uint64_t needed() const { return needed_; }
  std::uint64_t needed(Pool pool) const { return by_pool_[static_cast<std::size_t>(pool)]; }
  bool fits() const { return needed_ <= bytes_; }
  std::uint64_t bytes() const { return bytes_; }

 private:
  void* allocate_rows(Pool pool, std::uint32_t count, std::size_t bytes);

  std::byte* block_ = nullptr;
  std::uint64_t bytes_ = 0;
  std::uint64_t needed_ = 0;
  std::uint64_t by_pool_[kPoolCount] = {};
};

}  // namespace krait::detail
