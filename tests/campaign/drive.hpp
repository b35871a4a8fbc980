// SPDX-License-Identifier: Apache-2.0
// Drives controls in double precision: classic Runge-Kutta, each step halved until halving changes nothing.
#pragma once

#include <vector>

#include "equations.hpp"

namespace krait::campaign {

// The state `time` seconds after `from`, by one Runge-Kutta step.
State advanced(const Equations& equations, const State& from, const double* u, double time);

class Drive {
 public:
  // What a step of half the length changes at most, by component; the error left is about a fifteenth of it.
  static constexpr double kAccuracy = 1e-9;
  static constexpr int kMostParts = 1 << 14;

  explicit Drive(const Equations& equations) : equations_(equations) {}

  // Holds the control for `time` seconds. Returns the states on the way, equally far apart in time, the first and the
  // last included; none where kMostParts parts are not accurate.
  const std::vector<State>& hold(const State& from, const double* u, double time);

 private:
  void go(const State& from, const double* u, double time, int parts, std::vector<State>& way) const;
  double difference(const State& a, const State& b) const;

  const Equations& equations_;
  int parts_ = 1;  // accurate for the last step
  std::vector<State> coarse_, fine_;
};

}  // namespace krait::campaign
