// SPDX-License-Identifier: Apache-2.0
// A tractor with trailers that roll without slip: they follow with the rear axle's speed, s = v cos psi.
// A steady turn needs R^2 > N d^2 for the tail to follow; the steering keeps the curvature below that (chain.cpp).
#pragma once

#include "krait/robots/chain.hpp"

namespace krait {

class Truck : public Chain {
 public:
  explicit Truck(const ChainParameters& parameters) : Chain(parameters, false) {}
};

template <>
inline constexpr bool kAnswersProven<Truck> = true;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<Truck>;

}  // namespace krait
