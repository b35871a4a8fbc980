// SPDX-License-Identifier: Apache-2.0
// Sines and cosines of many angles, as many at a time as the processor has lanes. The same bits however many that are.
#pragma once

#include "base/lanes/lanes.hpp"
#include "krait/geometry.hpp"

#ifdef KRAIT_LANES
namespace krait::detail::lanes {

inline constexpr int kLeastAngles = 4;

// The trailers of a chain in a state near one whose hitch angles are known.
struct NearHitches {
  int count;                 // of trailers, at least kLeastAngles
  const float* turned;       // radians, count + 1: by how much the car's heading differs, then the trailers'
  const float* known_sines;  // of the hitch angles before the trailers
  const float* known_cosines;
};

// What math.hpp's turn_to says, for `count` of at least kLeastAngles.
void turn_frames(const float* angles, int count, Pose* frames);

// Sines and cosines of the hitch angles: the known ones, turned by what each has changed (small_sin_cos).
void turn_hitches(const NearHitches& near, float* sines, float* cosines);

#ifdef KRAIT_AVX2
// The same, of at least eight, for processors that have AVX2.
namespace avx2 {
inline constexpr int kLeastAngles = 8;
void turn_frames(const float* angles, int count, Pose* frames);
void turn_hitches(const NearHitches& near, float* sines, float* cosines);
}  // namespace avx2
#endif

}  // namespace krait::detail::lanes
#endif
