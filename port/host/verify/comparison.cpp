// SPDX-License-Identifier: Apache-2.0
#include "host/verify/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace krait::host {
namespace {

constexpr double kDifference = 5e-3;          // m, rad, m/s, rad/s
constexpr double kDifferencePerMetre = 5e-6;  // of way
constexpr double kChange = 1e-2;              // a second

double float_rounding(float value) {
  return static_cast<double>(std::abs(value) * std::numeric_limits<float>::epsilon());
}

}  // namespace

void Comparison::Worst::add(double other_value, double other_limit, std::size_t other_component) {
  if (value / limit < other_value / other_limit) *this = {other_value, other_limit, other_component};
}

Comparison::Comparison(const Dynamics& dynamics, double dt, Complaints& complaints)
    : dynamics_(dynamics),
      dt_(dt),
      complaints_(complaints),
      differences_(dynamics.state_size(), 0.0),
      roundings_(dynamics.state_size(), 0.0) {}

void Comparison::add(const State& driven, double length, const State& stored, const std::vector<float>& floats) {
  Worst difference;
  Worst change;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    const double now = stored[i] - driven[i];
    const double rounding = float_rounding(floats[i]);
    const double changed = std::abs(now - differences_[i]);
    difference.add(std::abs(now), kDifference + kDifferencePerMetre * length + rounding, i);
    change.add(changed, kChange * dt_ + rounding + roundings_[i], i);
    worst_difference_ = std::max(worst_difference_, std::abs(now));
    worst_change_ = std::max(worst_change_, changed);
    differences_[i] = now;
    roundings_[i] = rounding;
  }
  if (!failed_) judge(difference, change);
  ++count_;
}

void Comparison::judge(const Worst& difference, const Worst& change) {
  failed_ = difference.passes() || change.passes();
  if (!failed_) return;
  const Worst& worst = difference.passes() ? difference : change;
  const std::string state = "state " + text(count_) + ": " + dynamics_.state_names()[worst.component];
  const std::string limit = " (limit " + text(worst.limit) + ")";
  if (difference.passes()) {
    complaints_.add(state + " differs by " + text(worst.value) + " from where the controls lead" + limit);
  } else {
    complaints_.add(state + " strays by " + text(worst.value) + " in one step from where the controls lead" + limit);
  }
}

}  // namespace krait::host
