// Four floats at a time where the processor has them (SSE2, 64-bit Arm's NEON), with the scalar code's operations in
// the scalar code's order, so that every lane has the same bits. Not 32-bit Arm's NEON, which flushes denormals to
// zero.
#pragma once

#include <cstdint>
#include <cstring>

#if !defined(NO_LANES) && (defined(__SSE2__) || defined(__aarch64__))
#define KRAIT_LANES 1

namespace krait {

using Lanes = float __attribute__((vector_size(16)));
using IntLanes = std::int32_t __attribute__((vector_size(16)));
inline constexpr int kLanes = 4;

inline Lanes load_lanes(const float* values) {
  Lanes lanes;
  std::memcpy(&lanes, values, sizeof lanes);
  return lanes;
}
inline void store(Lanes lanes, float* values) { std::memcpy(values, &lanes, sizeof lanes); }
inline Lanes all_lanes(float x) { return Lanes{x, x, x, x}; }

// Calls visit(first) for blocks of kLanes that together are 0 to count - 1, count >= kLanes: the last may overlap the
// one before.
template <class Visit>
void for_each_block(int count, Visit visit) {
  for (int first = 0; first + kLanes < count; first += kLanes) visit(first);
  visit(count - kLanes);
}

}  // namespace krait
#endif
