// SPDX-License-Identifier: Apache-2.0
// The verdict's list of faults, bounded however bad the plan is.
#pragma once

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace krait::host {

// A number as a person reads it.
inline std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

inline std::string text(std::size_t value) { return std::to_string(value); }

class Complaints {
 public:
  void add(std::string line) { add_lasting({std::move(line), {}, {}}); }

  // A fault that may last: named where it begins, with the most that it comes to between two parts of its line.
  struct Lasting {
    std::string before;
    std::optional<double> most;  // absent: the line has no number
    std::string after;
  };

  // Returns what `raise` finds it by.
  std::size_t add_lasting(Lasting fault) {
    if (faults_.size() < kMostLines) faults_.push_back(std::move(fault));
    return count_++;
  }
  void raise(std::size_t fault, double amount) {
    if (fault >= faults_.size() || !faults_[fault].most) return;
    faults_[fault].most = std::max(*faults_[fault].most, amount);
  }

  void append(const Complaints& other) {
    for (const Lasting& fault : other.faults_) add_lasting(fault);
    count_ += other.count_ - other.faults_.size();
  }

  bool empty() const { return count_ == 0; }

  std::vector<std::string> lines() const {
    std::vector<std::string> all;
    for (const Lasting& fault : faults_) {
      all.push_back(fault.before + (fault.most ? text(*fault.most) : std::string()) + fault.after);
    }
    if (count_ > faults_.size()) all.push_back("and " + text(count_ - faults_.size()) + " more");
    return all;
  }

 private:
  static constexpr std::size_t kMostLines = 20;
  std::vector<Lasting> faults_;
  std::size_t count_ = 0;
};

}  // namespace krait::host
