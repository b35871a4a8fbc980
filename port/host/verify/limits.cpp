// SPDX-License-Identifier: Apache-2.0
#include "host/verify/limits.hpp"

#include <algorithm>
#include <cmath>

namespace krait::host {
namespace {

constexpr double kSlack = 1e-4;  // relative

double slack(const Limit& limit) { return kSlack * std::max(std::abs(limit.min), std::abs(limit.max)); }

// The extreme value of the parabola through three values at equal times, if it lies between the first and the last of
// these times; else the value in the middle. So it is where the values jump, as an angle does at a half turn.
double extreme(double first, double middle, double last) {
  const double rise = last - first;
  const double bend = first - 2 * middle + last;
  const bool between = std::abs(rise) < 2 * std::abs(bend) && std::abs(bend) < 1;
  return between ? middle - rise * rise / (8 * bend) : middle;
}

}  // namespace

LimitCheck::LimitCheck(const Dynamics& dynamics, Complaints& complaints)
    : dynamics_(dynamics), complaints_(complaints) {
  for (const Limit& limit : dynamics.state_limits()) of_state_.push_back({limit, {}});
  for (const Limit& limit : dynamics.control_limits()) of_control_.push_back({limit, {}});
}

std::string LimitCheck::Place::text() const { return where + (time > 0 ? " at " + host::text(time) + " s: " : ": "); }

void LimitCheck::check(const Place& place, double value, Quantity& quantity) {
  const Limit& limit = quantity.limit;
  const bool below = limit.min - value > value - limit.max;
  const double excess = below ? limit.min - value : value - limit.max;
  if (excess <= slack(limit)) return;
  if (!quantity.complaint) {
    const std::string passed = " is beyond its limit of " + text(below ? limit.min : limit.max) + " by up to ";
    quantity.complaint = complaints_.add_lasting({place.text() + limit.name + passed, excess, {}});
  }
  complaints_.raise(*quantity.complaint, excess);
}

void LimitCheck::check_state(const std::string& where, const State& state) {
  const std::vector<double> values = dynamics_.limited_values(state);
  for (std::size_t i = 0; i < values.size(); ++i) check({where}, values[i], of_state_[i]);
}

void LimitCheck::check_control(const std::string& where, const Control& control) {
  for (std::size_t i = 0; i < of_control_.size(); ++i) check({where}, control[i], of_control_[i]);
}

void LimitCheck::check_leg(const std::string& where, const Leg& leg, double time) {
  std::vector<std::vector<double>> values;
  for (const State& state : leg.states) values.push_back(dynamics_.limited_values(state));
  const double sub_step = time / static_cast<double>(values.size() - 1);
  for (std::size_t i = 1; i < values.size(); ++i) {
    const Place place{where, static_cast<double>(i) * sub_step};
    for (std::size_t k = 0; k < of_state_.size(); ++k) {
      check(place, values[i][k], of_state_[k]);
      if (i + 1 == values.size()) continue;
      check(place, extreme(values[i - 1][k], values[i][k], values[i + 1][k]), of_state_[k]);
    }
  }
}

}  // namespace krait::host
