// SPDX-License-Identifier: Apache-2.0
// What base/lanes/angles.hpp declares, for any number of lanes. Templates alone: what one file makes of them with
// instructions of its own no other file can come to use.
#pragma once

#include <limits>

#include "base/lanes/angles.hpp"

#ifdef KRAIT_LANES
namespace krait::detail::lanes {

// The scalar sin_cos, operation by operation.
template <int n>
SinCosOf<Lanes<n>> sin_cos(Lanes<n> x) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const IntLanes<n> inside = x * x <= kMaxAngle * kMaxAngle;
  x = inside ? x : Lanes<n>{};
  const auto quadrant = __builtin_convertvector(x * math::kQuarterTurns + (math::kQuarterShift + 0.5F), IntLanes<n>);
  const Lanes<n> turns = __builtin_convertvector(quadrant, Lanes<n>) - math::kQuarterShift;
  const SinCosOf<Lanes<n>> at = math::reduced_sin_cos(math::reduced_angle(x, turns));
  const IntLanes<n> swap = (quadrant & 1) != 0;
  const Lanes<n> sine = swap ? at.cos : at.sin;
  const Lanes<n> cosine = swap ? at.sin : at.cos;
  const Lanes<n> nan = Lanes<n>{} + kNan;
  const Lanes<n> signed_sine = (quadrant & 2) != 0 ? -sine : sine;
  const Lanes<n> signed_cosine = ((quadrant + 1) & 2) != 0 ? -cosine : cosine;
  return {inside ? signed_sine : nan, inside ? signed_cosine : nan};
}

template <int n>
void turn_frames_by(const float* angles, int count, Pose* frames) {
  for_each_block<n>(count, [=](int first) {
    const SinCosOf<Lanes<n>> result = sin_cos<n>(load_lanes<n>(angles + first));
    for (int lane = 0; lane < n; ++lane) frames[first + lane].heading = {result.sin[lane], result.cos[lane]};
  });
}

template <int n>
void turn_hitches_by(const NearHitches& near, float* sines, float* cosines) {
  for_each_block<n>(near.count, [=](int first) {
    const float* const turned = near.turned + first;
    const SinCosOf<Lanes<n>> turn = math::small_sin_cos(load_lanes<n>(turned) - load_lanes<n>(turned + 1));
    const Lanes<n> sine = load_lanes<n>(near.known_sines + first);
    const Lanes<n> cosine = load_lanes<n>(near.known_cosines + first);
    store_lanes(sine * turn.cos + cosine * turn.sin, sines + first);
    store_lanes(cosine * turn.cos - sine * turn.sin, cosines + first);
  });
}

}  // namespace krait::detail::lanes
#endif
