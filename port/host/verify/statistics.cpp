// SPDX-License-Identifier: Apache-2.0
#include "host/verify/statistics.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "host/input/json.hpp"

namespace krait::host {
namespace {

// m, of the line through the positions.
double length_of(const PlanFile& plan) {
  const auto step = [&](std::size_t i, std::size_t k) {
    return static_cast<double>(plan.states[i + 1][k]) - static_cast<double>(plan.states[i][k]);
  };
  double sum = 0;
  for (std::size_t i = 0; i < plan.controls.size(); ++i) sum += std::hypot(step(i, 0), step(i, 1));
  return sum;
}

double end_speed_of(const PlanFile& plan, const Dynamics& dynamics) {
  const std::vector<float>& end = plan.states.back();
  return dynamics.speed(State(end.begin(), end.end()));
}

// FNV-1a of 64 bits.
class Hash {
 public:
  // Each number as the four bytes of a float, the lowest first.
  void add(const std::vector<float>& row) {
    for (const float number : row) {
      const auto bits = std::bit_cast<std::uint32_t>(number);
      for (unsigned shift = 0; shift < 32; shift += 8) value_ = (value_ ^ ((bits >> shift) & 0xFFU)) * kPrime;
    }
  }

  std::string hexadecimal() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value_));
    return digits;
  }

 private:
  static constexpr std::uint64_t kPrime = 0x100000001B3;
  std::uint64_t value_ = 0xCBF29CE484222325;
};

// Of the states and controls in the order in which they are driven.
std::string hash_of(const PlanFile& plan) {
  Hash hash;
  for (std::size_t i = 0; i < plan.controls.size(); ++i) {
    hash.add(plan.states[i]);
    hash.add(plan.controls[i]);
  }
  hash.add(plan.states.back());
  return hash.hexadecimal();
}

}  // namespace

void check_statistics(const PlanFile& plan, const Dynamics& dynamics, Complaints& complaints) {
  if (!plan.statistics) return;
  const auto differs = [&](const std::string& key, const nlohmann::json& said, const std::string& is) {
    complaints.add("statistics: " + key + " is " + cleaned_name(said.dump()) + is);
  };
  const auto check = [&](const char* key, double is, double tolerance, const std::string& shown) {
    const auto said = plan.statistics->find(key);
    if (said == plan.statistics->end()) return;
    if (!said->is_number() || std::abs(said->get<double>() - is) > tolerance)
      differs(key, *said, ", the plan's is " + shown);
  };
  const std::size_t steps = plan.controls.size();
  const double duration = plan.dt * static_cast<double>(steps), length = length_of(plan);
  const double speed = end_speed_of(plan, dynamics);
  constexpr double kRounded = static_cast<double>(std::numeric_limits<float>::epsilon()), kRounding = 4 * kRounded;
  // The planner adds the lengths of the steps up in floats, each sum of which may be rounded once.
  const double rounded_sum = kRounding + static_cast<double>(steps) * kRounded;
  check("plan_steps", static_cast<double>(steps), 0, std::to_string(steps));
  check("plan_length_m", length, rounded_sum * (1 + length), text(length) + " m");
  check("plan_duration_s", duration, kRounding * (1 + duration), text(duration) + " s");
  check("plan_end_speed_m_s", speed, kRounding * (1 + std::abs(speed)), text(speed) + " m/s");
  const auto said = plan.statistics->find("hash");
  const std::string hash = hash_of(plan);
  if (said != plan.statistics->end() && *said != hash) {
    differs("hash", *said, ", that of states and controls is \"" + hash + "\"");
  }
}

}  // namespace krait::host
