// SPDX-License-Identifier: Apache-2.0
/// \file
/// A second-order car: the chain without trailers, its body centred on the middle of the wheelbase.
#pragma once

#include "krait/robots/truck.hpp"

namespace krait {

/// A car: a truck without trailers. Its members are the chain's.
class Car : public Truck {
 public:
  /// Copies the parameters, but for trailers, which are none, and body_offset, which is half the wheelbase.
  explicit Car(const ChainParameters& parameters) : Truck(centred(parameters)) {}

  /// A car has no trailers to push: it is steered as a chain. O(1).
  using Chain::steer;
  /// A car has no trailers to push: it is brought back to its reference as a chain. O(1).
  using Chain::track;

  /// The parameters of a car of 1.2 m by 0.6 m; the others are the chain's. O(1).
  static ChainParameters defaults() {
    ChainParameters parameters;
    parameters.body_length = 1.2F;
    parameters.body_width = 0.6F;
    return parameters;
  }

 private:
  static ChainParameters centred(ChainParameters parameters) {
    parameters.trailers = 0;
    parameters.body_offset = 0.5F * parameters.wheelbase;
    return parameters;
  }
};

/// The library does not check its results.
template <>
inline constexpr bool kAnswersProven<Car> = true;

/// It has no trailers.
template <>
inline constexpr bool kDocks<Car> = false;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<Car>;

}  // namespace krait
