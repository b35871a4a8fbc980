// SPDX-License-Identifier: Apache-2.0
// The paper's robot (Eqn 1): trailers follow with s = v, the speed of the front wheel, so that the tail pulls straight.
#pragma once

#include "krait/robots/chain.hpp"

namespace krait {

class Snake : public Chain {
 public:
  explicit Snake(const ChainParameters& parameters) : Chain(parameters, true) {}
};

template <>
inline constexpr bool kAnswersProven<Snake> = true;

// Compiled in the library, with its arithmetic.
extern template class detail::FunctionsOf<Snake>;

}  // namespace krait
