// SPDX-License-Identifier: Apache-2.0
// Gathers what a robot was found to do wrong, by function and promise.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "krait/robot_check.hpp"

namespace krait::detail::checking {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

// A state, and a control that is held from it on for dt seconds.
struct Sample {
  std::vector<float> state;
  std::vector<float> control;
  float dt = 0;
};

std::string number(double x, int digits = 4);

// Nine digits tell a float from every other.
std::string list(const std::vector<float>& numbers);

// Gathers faults, of each function and promise the worst.
class Findings {
 public:
  explicit Findings(RobotReport& report) : report_(&report) {}

  void begin_sample() { ++report_->samples; }

  // `what` is wrong, by `amount`; `remedy` is a sentence.
  void add(const char* function, const char* promise, double amount, const std::string& what, const Sample& sample,
           const char* remedy);

  // A fault of the whole check, not of one sample.
  void add(const char* function, const char* promise, const std::string& sentence, double amount = kInfinite);

 private:
  RobotFault& find(const char* function, const char* promise);

  RobotReport* report_;
  std::vector<int> last_;  // by fault: the last sample that it was found in
  std::size_t place_ = 0;  // of the fault that was found last
};

}  // namespace krait::detail::checking
