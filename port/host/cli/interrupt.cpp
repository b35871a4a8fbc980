// SPDX-License-Identifier: Apache-2.0
#include "host/cli/interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <cstring>

namespace krait::host {
namespace {

volatile std::sig_atomic_t noted = 0;

void note(int signal) {
  noted = 1;
  std::signal(signal, SIG_DFL);
}

using Handler = void (*)(int);

// Has the handler called, unless SIGINT is ignored; returns the one before.
Handler listen(Handler handler) {
  const Handler before = std::signal(SIGINT, handler);
  if (before == SIG_IGN) std::signal(SIGINT, SIG_IGN);
  return before;
}

const char* volatile last_line = "";

// By what a handler of signals may call.
void say_and_end(int signal) {
  const char* const line = last_line;
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line, std::strlen(line));
  std::signal(signal, SIG_DFL);
  ::raise(signal);
}

}  // namespace

Interrupt::Interrupt() : before_(listen(note)) { noted = 0; }

Interrupt::~Interrupt() { std::signal(SIGINT, before_); }

bool Interrupt::asked() const { return noted != 0; }

LastWord::LastWord(const char* line) {
  last_line = line;
  before_ = listen(say_and_end);
}

LastWord::~LastWord() { std::signal(SIGINT, before_); }

}  // namespace krait::host
