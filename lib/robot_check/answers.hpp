// SPDX-License-Identifier: Apache-2.0
// Whether the results of a robot's functions are finite, complete and the same when called again.
#pragma once

#include <functional>

#include "robot_check/case.hpp"

namespace krait::detail::checking {

bool same_bits(const std::vector<float>& a, const std::vector<float>& b);

std::vector<float> numbers_of(const std::vector<Pose>& poses);
std::vector<float> numbers_of(const Travel& t);

struct TravelAnswer {
  bool limits_kept = false;
  std::vector<Travel> bodies;
};

// `fill` is there before.
TravelAnswer travel_of(const Robot& robot, const Sample& sample, const std::vector<float>& next, float fill);
std::vector<float> numbers_of(const TravelAnswer& answer);

// The result of a function for a state, as numbers; `fill` is there before.
using Ask = std::function<std::vector<float>(const std::vector<float>& state, float fill)>;

// Asks twice, about the other state in between.
void check_repeats(const Case& c, const char* function, const Ask& ask);

// Whether a number that a function returns is what the rule asks for; where it is not, that is a fault.
bool check_number(const Case& c, const char* function, bool holds, float value, const char* unit, const char* rule);

// False where nothing else can be checked of the sample.
bool check_derivative(const Case& c);
bool check_place(const Case& c);

void check_within_limits(const Case& c);
void check_bodies(const Case& c);

}  // namespace krait::detail::checking
