// The verdict's list of faults, bounded however bad the plan is.
#pragma once

#include <cstdio>
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
  void add(std::string line) {
    ++count_;
    if (lines_.size() < kMostLines) lines_.push_back(std::move(line));
  }

  bool empty() const { return count_ == 0; }

  // The plan is so bad that looking on tells nobody more.
  bool enough() const { return count_ >= kEnough; }

  std::vector<std::string> lines() const {
    std::vector<std::string> all = lines_;
    if (count_ > lines_.size()) all.push_back("and " + text(count_ - lines_.size()) + " more");
    return all;
  }

 private:
  static constexpr std::size_t kMostLines = 20;
  static constexpr std::size_t kEnough = 1000;
  std::vector<std::string> lines_;
  std::size_t count_ = 0;
};

}  // namespace krait::host
