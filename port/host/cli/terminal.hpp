// SPDX-License-Identifier: Apache-2.0
// A line of progress on a terminal, for whatever takes over a second; silent elsewhere.
#pragma once

#include <string>

namespace krait::host {

class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Replaces the line.
  void show(const std::string& text);

 private:
  bool terminal_;
  bool shown_ = false;
};

}  // namespace krait::host
