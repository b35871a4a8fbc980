// SPDX-License-Identifier: Apache-2.0
// What a robot was found to do wrong, by function and promise. For hosts.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace krait {

// A promise that a function of a robot does not keep, in the worst case that was found.
struct RobotFault {
  std::string function;  // travel
  std::string promise;   // path
  std::string message;   // what, by how much, at which state and control, and what to do
  double by = 0;         // in the promise's own unit
  int samples = 0;       // in how many it was found
};

struct RobotReport {
  std::vector<RobotFault> faults;
  int samples = 0;  // that were looked at

  bool ok() const { return faults.empty(); }

  // A line for each fault; empty where there is none.
  std::string text() const {
    std::string lines;
    for (const RobotFault& fault : faults) {
      lines += fault.function + " (" + fault.promise + "): " + fault.message + " Found in " +
               std::to_string(fault.samples) + " of " + std::to_string(samples) + " samples.\n";
    }
    return lines;
  }
};

namespace checking {

// A state, and a control that is held from it on for dt seconds.
struct Sample {
  std::vector<float> state;
  std::vector<float> control;
  float dt = 0;
};

inline std::string number(double x, int digits = 4) {
  char text[32];
  const int length = std::snprintf(text, sizeof text, "%.*g", digits, x);
  return {text, static_cast<std::size_t>(length)};
}

// Nine digits tell a float from every other.
inline std::string list(const std::vector<float>& numbers) {
  std::string text = "[";
  for (const float x : numbers) text += (text.size() > 1 ? ", " : "") + number(static_cast<double>(x), 9);
  return text + "]";
}

inline std::string where(const Sample& sample) {
  return "at the state " + list(sample.state) + " under the control " + list(sample.control) + " for " +
         number(static_cast<double>(sample.dt), 9) + " s";
}

// Gathers faults, of each function and promise the worst.
class Findings {
 public:
  explicit Findings(RobotReport& report) : report_(&report) {}

  void begin_sample() { ++report_->samples; }

  // `what` is wrong, by so much; `remedy` is a sentence.
  void add(const char* function, const char* promise, double by, const std::string& what, const Sample& sample,
           const char* remedy) {
    RobotFault& fault = find(function, promise);
    const bool worst = fault.samples == 0 || by > fault.by;
    if (last_[place_] != report_->samples) ++fault.samples;
    last_[place_] = report_->samples;
    if (!worst) return;
    fault.by = by;
    fault.message = what + ", " + where(sample) + ". " + remedy;
  }

  // A fault of the whole check, not of one sample.
  void add(const char* function, const char* promise, const std::string& sentence) {
    RobotFault& fault = find(function, promise);
    fault.message = sentence;
    fault.samples = report_->samples;
  }

 private:
  RobotFault& find(const char* function, const char* promise) {
    for (place_ = 0; place_ < report_->faults.size(); ++place_) {
      RobotFault& fault = report_->faults[place_];
      if (fault.function == function && fault.promise == promise) return fault;
    }
    last_.push_back(-1);
    return report_->faults.emplace_back(RobotFault{function, promise, {}, 0, 0});
  }

  RobotReport* report_;
  std::vector<int> last_;  // by fault: the last sample that it was found in
  std::size_t place_ = 0;
};

}  // namespace checking
}  // namespace krait
