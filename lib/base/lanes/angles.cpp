// SPDX-License-Identifier: Apache-2.0
#include "base/lanes/angles.hpp"

#include "base/lanes/kernels.hpp"

#ifdef KRAIT_LANES
namespace krait::detail::lanes {

void turn_frames(const float* angles, int count, Pose* frames) {
#ifdef KRAIT_AVX2
  if (count >= avx2::kLeastAngles && __builtin_cpu_supports("avx2")) return avx2::turn_frames(angles, count, frames);
#endif
  turn_frames_by<kLeastAngles>(angles, count, frames);
}

void turn_hitches(const NearHitches& near, float* sines, float* cosines) {
#ifdef KRAIT_AVX2
  if (near.count >= avx2::kLeastAngles && __builtin_cpu_supports("avx2")) {
    return avx2::turn_hitches(near, sines, cosines);
  }
#endif
  turn_hitches_by<kLeastAngles>(near, sines, cosines);
}

}  // namespace krait::detail::lanes
#endif
