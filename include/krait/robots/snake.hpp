// SPDX-License-Identifier: Apache-2.0
/// \file
/// The paper's robot (Eqn 1): trailers follow with s = v, the speed of the front wheel, so that the tail pulls
/// straight.
#pragma once

#include "krait/robots/chain.hpp"

namespace krait {

/// The paper's robot: a chain whose trailers slip. Its members are the chain's.
class Snake : public Chain {
 public:
  /// Copies the parameters; sound() says whether they can be used.
  explicit Snake(const ChainParameters& parameters) : Chain(parameters, true) {}
};

/// The library does not check its results.
template <>
inline constexpr bool kAnswersProven<Snake> = true;
/// Its trailers are not pushed into narrow places.
template <>
inline constexpr bool kParks<Snake> = false;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<Snake>;

}  // namespace krait
