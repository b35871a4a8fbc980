// SPDX-License-Identifier: Apache-2.0
// A second-order car: the chain without trailers, its body centred on the middle of the wheelbase.
#pragma once

#include "krait/robots/truck.hpp"

namespace krait {

class Car : public Truck {
 public:
  explicit Car(const ChainParameters& parameters) : Truck(centred(parameters)) {}

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

template <>
inline constexpr bool kAnswersProven<Car> = true;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<Car>;

}  // namespace krait
