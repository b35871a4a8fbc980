// SPDX-License-Identifier: Apache-2.0
/// \file
/// A tractor with trailers that roll without slip: they follow with the rear axle's speed, s = v cos psi. N trailers of
/// hitch length d follow a steady turn of radius R only where R^2 > N d^2; the steering turns no tighter.
#pragma once

#include "krait/robots/chain.hpp"

namespace krait {

/// A tractor with trailers: a chain that rolls without slip. Its members are the chain's, but for these: backwards it
/// leads the last of up to three trailers to the target's point.
class Truck : public Chain {
 public:
  /// Copies the parameters; sound() says whether they can be used.
  explicit Truck(const ChainParameters& parameters) : Chain(parameters, false) {}

  /// The last trailer, where the truck can drive backwards and pulls at most three; else the tractor. O(1).
  int backing_body() const;
  /// Steers the tractor as a chain does; backwards the backing body. O(trailers): it places all bodies.
  void steer(StateView s, const Target& target, Steering& steering, ControlRef u) const;
  /// The same, knowing the frames of all bodies. O(1).
  void steer(StateView s, const Pose* poses, const Target& target, Steering& steering, ControlRef u) const;
  /// Forwards Chain::track; backwards it brings the backing body back to its reference's line, and all hitches to
  /// their reference angles. O(trailers): it places all bodies.
  void track(StateView s, StateView reference, float dt, ControlRef u) const;
};

/// The library does not check its results.
template <>
inline constexpr bool kAnswersProven<Truck> = true;
/// It docks: it pushes its trailers to a pose instead.
template <>
inline constexpr bool kParks<Truck> = false;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<Truck>;

}  // namespace krait
