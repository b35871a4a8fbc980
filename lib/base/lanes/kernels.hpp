// SPDX-License-Identifier: Apache-2.0
// What base/lanes/angles.hpp declares, for any number of lanes. Templates alone: what one file makes of them with
// instructions of its own no other file can come to use.
#pragma once

#include <limits>

#include "base/lanes/angles.hpp"

#ifdef KRAIT_LANES
namespace krait::lanes {

// The scalar sin_cos, operation by operation.
template <int n>
SinCosOf<Lanes<n>> sin_cos(Lanes<n> x) {
  constexpr float kShift = 8192.0F;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const IntLanes<n> inside = x * x <= kMaxAngle * kMaxAngle;
  x = inside ? x : Lanes<n>{};
  const auto quadrant = __builtin_convertvector(x * 0.636619772367581F + (kShift + 0.5F), IntLanes<n>);
  const Lanes<n> turns = __builtin_convertvector(quadrant, Lanes<n>) - kShift;
  const Lanes<n> r = ((x - turns * 1.5703125F) - turns * 4.837512969970703125e-4F) - turns * 7.54978995489188216e-8F;
  const Lanes<n> z = r * r;
  const Lanes<n> s = ((-1.9515295891e-4F * z + 8.3321608736e-3F) * z - 1.6666654611e-1F) * z * r + r;
  const Lanes<n> c =
      ((2.443315711809948e-5F * z - 1.388731625493765e-3F) * z + 4.166664568298827e-2F) * z * z - 0.5F * z + 1.0F;
  const IntLanes<n> swap = (quadrant & 1) != 0;
  const Lanes<n> sine = swap ? c : s;
  const Lanes<n> cosine = swap ? s : c;
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
    const SinCosOf<Lanes<n>> turn = small_sin_cos(load_lanes<n>(turned) - load_lanes<n>(turned + 1));
    const Lanes<n> sine = load_lanes<n>(near.known_sines + first);
    const Lanes<n> cosine = load_lanes<n>(near.known_cosines + first);
    store_lanes(sine * turn.cos + cosine * turn.sin, sines + first);
    store_lanes(cosine * turn.cos - sine * turn.sin, cosines + first);
  });
}

}  // namespace krait::lanes
#endif
