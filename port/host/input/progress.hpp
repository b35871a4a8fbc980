// SPDX-License-Identifier: Apache-2.0
// Tells a person who waits what a program is doing. On a terminal: one line on standard error, rewritten, from the
// first second on. Elsewhere: one line for each step that has lasted five seconds, and nothing for a quick one.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace krait::host {

class Progress {
 public:
  // `program` begins each line.
  explicit Progress(std::string program);
  // As end().
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // What is being done from now on, "planning", and what can be said of it, "1200 iterations". The same step with
  // another detail is the same step. Costs a lock.
  void show(const std::string& step, const std::string& detail = {});

  // Nothing is being done any more: clears the line. Does not wait for the next redraw. show() may follow.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  void watch();
  void draw();  // under the lock

  const std::string program_;
  const bool terminal_;
  const Clock::time_point begin_ = Clock::now();
  std::mutex mutex_;  // of what follows
  std::string step_;
  std::string detail_;
  Clock::time_point step_begin_;
  bool shown_ = false;      // the line stands on the terminal
  bool announced_ = false;  // the step has had its line elsewhere
  bool ended_ = false;
  std::condition_variable woken_;  // ended_ is set
  std::thread watcher_;
};

}  // namespace krait::host
