// SPDX-License-Identifier: Apache-2.0
// Targets as they are stored and driven: rounded, in 8 bytes.
#pragma once

#include <cstdint>

#include "krait/robots/model.hpp"

namespace krait::detail {

struct PackedTarget {
  std::uint16_t x;  // in parts of the bounds
  std::uint16_t y;
  std::int16_t speed;  // in parts of 1 / 32767
  std::uint16_t turn;  // in parts of 1 / 65535
};

// Rounds points to 1/65535 of the bounds in x and y.
class TargetGrid {
 public:
  TargetGrid() = default;
  explicit TargetGrid(const Box& bounds);

  // A point beyond the bounds becomes the nearest one on them.
  PackedTarget pack(const Target& target) const;
  // Target::dt is not stored.
  Target unpack(const PackedTarget& packed) const;

 private:
  Vec2 low_{};
  Vec2 unit_{};
};

}  // namespace krait::detail
