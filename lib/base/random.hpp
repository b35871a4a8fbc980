// SPDX-License-Identifier: Apache-2.0
// The core's random numbers: xoshiro128++ (Blackman, Vigna 2018), seeded by SplitMix64. Integers only, so that
// the sequence is the same on every target.
#pragma once

#include <bit>
#include <cstdint>

#include "krait/status.hpp"

namespace krait::detail {

class Random {
 public:
  // Not all of the state is zero: of two numbers in a row one is not, and what these steps make of it is not either.
  explicit Random(std::uint64_t seed = 1) {
    for (int i = 0; i < 4; i += 2) {
      seed += 0x9E3779B97F4A7C15ULL;
      std::uint64_t z = seed;
      z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
      z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
      z ^= z >> 31U;
      state_[i] = static_cast<std::uint32_t>(z);
      state_[i + 1] = static_cast<std::uint32_t>(z >> 32U);
    }
  }

  std::uint32_t bits() {
    const std::uint32_t result = std::rotl(state_[0] + state_[3], 7) + state_[0];
    const std::uint32_t t = state_[1] << 9U;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = std::rotl(state_[3], 11);
    return result;
  }

  // Uniform on 0 … count - 1 (Lemire's multiply; the bias is below count / 2^32). count > 0.
  std::uint32_t below(std::uint32_t count) {
    KRAIT_ASSERT(count > 0);
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(bits()) * count) >> 32U);
  }

  // Uniform on the multiples of 2^-24 in [0, 1).
  float unit() { return static_cast<float>(bits() >> 8U) * 0x1p-24F; }

 private:
  std::uint32_t state_[4];
};

}  // namespace krait::detail
