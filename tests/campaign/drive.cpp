// SPDX-License-Identifier: Apache-2.0
#include "drive.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace krait::campaign {

State advanced(const Equations& equations, const State& from, const double* u, double time) {
  const auto n = static_cast<std::size_t>(equations.state_size());
  State k1, k2, k3, k4, at;
  equations.rates(from, u, k1);
  for (std::size_t i = 0; i < n; ++i) at[i] = from[i] + time / 2 * k1[i];
  equations.rates(at, u, k2);
  for (std::size_t i = 0; i < n; ++i) at[i] = from[i] + time / 2 * k2[i];
  equations.rates(at, u, k3);
  for (std::size_t i = 0; i < n; ++i) at[i] = from[i] + time * k3[i];
  equations.rates(at, u, k4);
  for (std::size_t i = 0; i < n; ++i) at[i] = from[i] + time / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  return at;
}

void Drive::go(const State& from, const double* u, double time, int parts, std::vector<State>& way) const {
  way.assign(1, from);
  for (int i = 0; i < parts; ++i) way.push_back(advanced(equations_, way.back(), u, time / parts));
}

// Of the components, less what rounding makes of large ones; infinite for NaN.
double Drive::difference(const State& a, const State& b) const {
  double most = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(equations_.state_size()); ++i) {
    const double apart = std::abs(a[i] - b[i]) - 1e-13 * std::abs(a[i]);
    if (!(apart <= std::numeric_limits<double>::max())) return std::numeric_limits<double>::infinity();
    most = std::max(most, apart);
  }
  return most;
}

const std::vector<State>& Drive::hold(const State& from, const double* u, double time) {
  go(from, u, time, parts_, coarse_);
  go(from, u, time, 2 * parts_, fine_);
  while (difference(coarse_.back(), fine_.back()) > kAccuracy) {
    parts_ *= 2;
    if (parts_ > kMostParts) {
      fine_.clear();
      return fine_;
    }
    std::swap(coarse_, fine_);
    go(from, u, time, 2 * parts_, fine_);
  }
  if (parts_ > 1 && difference(coarse_.back(), fine_.back()) < kAccuracy / 64) parts_ /= 2;
  return fine_;
}

}  // namespace krait::campaign
