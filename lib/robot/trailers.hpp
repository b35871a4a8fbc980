// SPDX-License-Identifier: Apache-2.0
// Trailers that are each hitched over the axle before: how fast they turn, and how far the wheels of a car may be
// turned whose trailers roll without slip: in a steady turn N trailers follow only where R^2 > N d^2, and the first
// hitch must not close in on its bound faster than it can recover (lemmas 14 and 15 of lib/robot/CHAIN.md).
#pragma once

#include <algorithm>

#include "krait/robots/chain.hpp"

namespace krait::detail {

// Writes the rates of trailers by the pull on the first; hitch(k) returns the hitch angle before trailer k. A trailer
// turns at the pull on it times the angle's sine, and pulls on by as much of it as the cosine leaves.
template <class Hitch>
void trailer_rates(float pull, int trailers, const Hitch& hitch, float* ds) {
  for (int k = 0; k < trailers; ++k) {
    const SinCos angle = hitch(k);
    ds[k] = pull * angle.sin;
    pull = pull * angle.cos;
  }
}

// Writes the headings of trailers where a robot rests: `angles`, or where they are null that of the car.
inline void rest_trailers(float heading, const float* angles, int trailers, float* headings) {
  for (int i = 0; i < trailers; ++i) headings[i] = angles != nullptr ? angles[i] : heading;
}

// Of lemma 15: k, 1/s, how fast the first hitch may close in on its bound, and B, radians, that bound: more than the
// 1.141 of a steady turn (lemma 14), and less than pi/2. lib/robot/CHAIN.md, "How tightly trailers follow", has both
// numbers, and that of the least speed.
inline constexpr float kUnfoldRate = 2.0F;
inline constexpr float kFoldBound = 1.2F;
inline constexpr float kLeastSpeed = 0.1F;  // m/s: a slower speed counts as this one, so that the bound is smaller

// The most tangent of the steering angle of a turn that all trailers follow for long, by lemma 14. P: ChainParameters
// or the like.
template <class P>
[[gnu::always_inline]] inline float steady_tangent(const P& p) {
  return p.wheelbase / (Chain::kTurnReserve * p.hitch_length * std::sqrt(static_cast<float>(p.trailers)));
}

// The most toward the side on which the first hitch angle is `hitch`, radians, at `speed` m/s: lemma 15, which holds
// forwards; in reverse the same number is the bound, and nothing is proven.
template <class P>
[[gnu::always_inline]] inline float recoverable_tangent(const P& p, float hitch, float speed) {
  const float bound = std::min(kFoldBound, p.max_hitch_angle);
  const float recovery = kUnfoldRate * (bound - hitch) / std::max(kLeastSpeed, math::absolute(speed));
  return p.wheelbase * (math::sin_cos(hitch).sin / p.hitch_length + recovery);
}

}  // namespace krait::detail
