// SPDX-License-Identifier: Apache-2.0
#include "host/input/interrupt.hpp"

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
volatile std::sig_atomic_t over_progress = 0;  // whether a line of progress may stand where the last one goes

void write_out(const char* text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text));
}

// Calls only what a handler of signals may.
void say_and_end(int signal) {
  if (over_progress != 0) write_out("\r\033[K");
  write_out(last_line);
  std::signal(signal, SIG_DFL);
  ::raise(signal);
}

}  // namespace

Interrupt::Interrupt() : before_(listen(note)) { noted = 0; }

Interrupt::~Interrupt() { std::signal(SIGINT, before_); }

bool Interrupt::asked() const { return noted != 0; }

LastWord::LastWord(const char* line) {
  last_line = line;
  over_progress = ::isatty(STDERR_FILENO);
  before_ = listen(say_and_end);
}

LastWord::~LastWord() { std::signal(SIGINT, before_); }

}  // namespace krait::host
