// SPDX-License-Identifier: Apache-2.0
#include "host/input/progress.hpp"

#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace krait::host {
namespace {

using namespace std::chrono_literals;

constexpr auto kTick = 200ms;
constexpr auto kQuiet = 1s;      // on a terminal
constexpr auto kLongQuiet = 5s;  // elsewhere

// Starts a thread that no signal is delivered to: they are the program's.
template <class Run>
std::thread without_signals(Run run) {
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(run);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

}  // namespace

Progress::Progress(std::string program) : program_(std::move(program)), terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { end(); }

void Progress::show(const std::string& step, const std::string& detail) {
  {
    const std::lock_guard lock(mutex_);
    if (step_ != step) {
      step_begin_ = Clock::now();
      announced_ = false;
    }
    step_ = step;
    detail_ = detail;
  }
  if (watcher_.joinable()) return;
  ended_ = false;
  watcher_ = without_signals([this] { watch(); });
}

void Progress::end() {
  if (!watcher_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  woken_.notify_one();
  watcher_.join();
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
  step_.clear();
}

void Progress::watch() {
  std::unique_lock lock(mutex_);
  while (!woken_.wait_for(lock, kTick, [this] { return ended_; })) draw();
}

void Progress::draw() {
  const auto lasted = Clock::now() - step_begin_;
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(lasted).count();
  const std::string about = detail_.empty() ? "" : ", " + detail_;
  if (terminal_ && Clock::now() - begin_ >= kQuiet) {
    std::fprintf(stderr, "\r\033[K%s: %s: %lld s%s", program_.c_str(), step_.c_str(), static_cast<long long>(seconds),
                 about.c_str());
    shown_ = true;
  } else if (!terminal_ && lasted >= kLongQuiet && !announced_) {
    std::fprintf(stderr, "%s: %s lasts%s\n", program_.c_str(), step_.c_str(), about.c_str());
    announced_ = true;
  }
}

}  // namespace krait::host
