// SPDX-License-Identifier: Apache-2.0
// An array of indices in a pool, two bytes each where all of them fit.
#pragma once

#include "base/arena.hpp"
#include "krait/geometry.hpp"

namespace krait::detail {

class PackedIndices {
 public:
  // Room for `count` indices below `limit`, or kNone.
  void allocate(Arena& arena, Pool pool, std::uint32_t count, std::uint32_t limit) {
    wide_ = limit > kNone16;
    if (wide_) {
      data_ = arena.allocate<std::uint32_t>(pool, count);
    } else {
      data_ = arena.allocate<std::uint16_t>(pool, count);
    }
  }

  Index operator[](std::size_t i) const {
    if (wide_) return static_cast<const std::uint32_t*>(data_)[i];
    const Index index = static_cast<const std::uint16_t*>(data_)[i];
    return index == kNone16 ? kNone : index;
  }

  void set(std::size_t i, Index index) {
    if (wide_) {
      static_cast<std::uint32_t*>(data_)[i] = index;
    } else {
      static_cast<std::uint16_t*>(data_)[i] = static_cast<std::uint16_t>(index);
    }
  }

 private:
  static constexpr auto kNone16 = static_cast<std::uint16_t>(kNone);  // where two bytes are enough for each

  void* data_ = nullptr;
  bool wide_ = false;
};

}  // namespace krait::detail
