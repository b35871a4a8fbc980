// SPDX-License-Identifier: Apache-2.0
#include "host/cli/terminal.hpp"

#include <unistd.h>

#include <cstdio>

namespace krait::host {
namespace {
constexpr const char* kClearLine = "\r\033[K";
}

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs(kClearLine, stderr);
}

void ProgressLine::show(const std::string& text) {
  if (!terminal_) return;
  std::fprintf(stderr, "%s%s", kClearLine, text.c_str());
  shown_ = true;
}

}  // namespace krait::host
