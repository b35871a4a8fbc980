// SPDX-License-Identifier: Apache-2.0
// Several floats at a time where the processor can: four with SSE2 and 64-bit Arm's NEON, eight with AVX2. Every lane
// does the scalar code's operations in the scalar code's order, so that it has the same bits. Not 32-bit Arm's NEON,
// which flushes denormals to zero.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__SSE2__) || defined(__aarch64__)
#define KRAIT_LANES 1
#endif

namespace krait::detail {

template <int n>
struct LaneTypes {
  using Floats [[gnu::vector_size(4 * n)]] = float;
  using Integers [[gnu::vector_size(4 * n)]] = std::int32_t;
};
template <int n>
using Lanes = typename LaneTypes<n>::Floats;
template <int n>
using IntLanes = typename LaneTypes<n>::Integers;

template <int n>
Lanes<n> load_lanes(const float* values) {
  Lanes<n> lanes;
  std::memcpy(&lanes, values, sizeof lanes);
  return lanes;
}
template <class Vector>
void store_lanes(Vector lanes, float* values) {
  std::memcpy(values, &lanes, sizeof lanes);
}

// Calls visit(first) for blocks of n that together are 0 to count - 1, count >= n: the last may overlap the one before.
template <int n, class Visit>
void for_each_block(int count, Visit visit) {
  for (int first = 0; first < count; first += n) visit(first + n <= count ? first : count - n);
}

}  // namespace krait::detail
