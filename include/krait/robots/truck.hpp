// SPDX-License-Identifier: Apache-2.0
/// \file
/// A tractor with trailers that roll without slip: they follow with the rear axle's speed, s = v cos psi.
/// A steady turn needs R^2 > N d^2 for the tail to follow; the steering keeps the curvature below that (chain.cpp).
#pragma once

#include "krait/robots/chain.hpp"

namespace krait {

/// A tractor with trailers: a chain that rolls without slip. Its members are the chain's.
class Truck : public Chain {
 public:
  /// Copies the parameters; sound() says whether they can be used.
  explicit Truck(const ChainParameters& parameters) : Chain(parameters, false) {}
};

/// Its answers need no second look.
template <>
inline constexpr bool kAnswersProven<Truck> = true;
/// Its trailers are not pushed into narrow places.
template <>
inline constexpr bool kParks<Truck> = false;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<Truck>;

}  // namespace krait
