// SPDX-License-Identifier: Apache-2.0
#include "robot_check/report.hpp"

#include <cstdio>

namespace krait {

std::string RobotReport::text() const {
  std::string lines;
  for (const RobotFault& fault : faults) {
    lines += fault.function + " (" + fault.promise + "): " + fault.message;
    if (fault.samples > 0) {
      lines += " Found in " + std::to_string(fault.samples) + " of " + std::to_string(samples) + " samples.";
    }
    lines += "\n";
  }
  return lines;
}

}  // namespace krait

namespace krait::detail::checking {
namespace {

std::string where(const Sample& sample) {
  return "at the state " + list(sample.state) + " under the control " + list(sample.control) + " for " +
         number(static_cast<double>(sample.dt), 9) + " s";
}

}  // namespace

std::string number(double x, int digits) {
  char text[32];
  const int length = std::snprintf(text, sizeof text, "%.*g", digits, x);
  return {text, static_cast<std::size_t>(length)};
}

std::string list(const std::vector<float>& numbers) {
  std::string text = "[";
  for (const float x : numbers) text += (text.size() > 1 ? ", " : "") + number(static_cast<double>(x), 9);
  return text + "]";
}

void Findings::add(const char* function, const char* promise, double amount, const std::string& what,
                   const Sample& sample, const char* remedy) {
  RobotFault& fault = find(function, promise);
  const bool worst = fault.samples == 0 || amount > fault.amount;
  if (last_[place_] != report_->samples) ++fault.samples;
  last_[place_] = report_->samples;
  if (!worst) return;
  fault.amount = amount;
  fault.message = what + ", " + where(sample) + ". " + remedy;
}

void Findings::add(const char* function, const char* promise, const std::string& sentence, double amount) {
  RobotFault& fault = find(function, promise);
  fault.message = sentence;
  fault.amount = amount;
}

RobotFault& Findings::find(const char* function, const char* promise) {
  for (place_ = 0; place_ < report_->faults.size(); ++place_) {
    RobotFault& fault = report_->faults[place_];
    if (fault.function == function && fault.promise == promise) return fault;
  }
  last_.push_back(-1);
  return report_->faults.emplace_back(RobotFault{function, promise, {}, 0, 0});
}

}  // namespace krait::detail::checking
