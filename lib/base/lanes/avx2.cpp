// SPDX-License-Identifier: Apache-2.0
// Compiled for AVX2 as no other file is: nothing here runs on a processor that does not report AVX2.
#include "base/lanes/kernels.hpp"

#ifdef KRAIT_AVX2
namespace krait::detail::lanes::avx2 {

void turn_frames(const float* angles, int count, Pose* frames) { turn_frames_by<kLeastAngles>(angles, count, frames); }

void turn_hitches(const NearHitches& near, float* sines, float* cosines) {
  turn_hitches_by<kLeastAngles>(near, sines, cosines);
}

}  // namespace krait::detail::lanes::avx2
#endif
