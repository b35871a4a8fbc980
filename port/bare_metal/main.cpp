// SPDX-License-Identifier: Apache-2.0
#include "bare_metal/main.hpp"

#include "bare_metal/console.hpp"
#include "bare_metal/memory.hpp"
#include "firmware/application.hpp"

namespace krait::bare_metal {
namespace {

constexpr std::size_t kMaxLine = 256;  // characters of a command line
constexpr int kMaxWords = 24;

std::uint64_t clock(void*) { return nanoseconds(ticks()); }
void log(void*, const char* text) { console_write(text); }
void fault(void*, const char* what) { report_fault(what, nullptr, 0); }

// Copies the text. False where it is longer than a line.
bool take_line(const char* text, char* line) {
  std::size_t i = 0;
  for (; text[i] != '\0' && i + 1 < kMaxLine; ++i) line[i] = text[i];
  line[i] = '\0';
  return text[i] == '\0';
}

// Cuts the line at its spaces, in place. Returns the number of words; those beyond kMaxWords are not kept.
int split(char* line, const char** words) {
  int count = 0;
  bool in_word = false;
  for (char* c = line; *c != '\0'; ++c) {
    if (*c == ' ') {
      *c = '\0';
      in_word = false;
    } else if (!in_word) {
      if (count < kMaxWords) words[count] = c;
      ++count;
      in_word = true;
    }
  }
  return count;
}

void log_hexadecimal(std::uintptr_t value) {
  constexpr unsigned kDigits = 2 * sizeof value;
  char text[kDigits + 1];
  for (unsigned i = 0; i < kDigits; ++i) text[i] = "0123456789abcdef"[(value >> (4 * (kDigits - 1 - i))) & 15U];
  text[kDigits] = '\0';
  console_write(text);
}

int run_application() {
  static char line[kMaxLine];
  static const char* words[kMaxWords];
  static firmware::Board board;
  board.name = KRAIT_BOARD;
  board.port = {nullptr, clock, log, fault};
  describe_memory(board);
  auto* const text = static_cast<char*>(board.arena);  // which nobody uses yet: a console may have more than a line
  console_command_line(text, board.arena_room);
  const bool whole = take_line(text, line);
  const int count = split(line, words);
  if (!whole || count > kMaxWords) {
    static_assert(kMaxLine == 256 && kMaxWords == 24, "the text below names them");
    console_write("krait: the command line has more than 255 characters or 24 words: leave out what is a default\n");
    return firmware::kBadInput;
  }
  return count == 0 ? firmware::run(board, 0, words) : firmware::run(board, count - 1, words + 1);
}

}  // namespace

void report_fault(const char* what, const NamedWord* words, int count) {
  console_write("krait: fault: ");
  console_write(what);
  for (int i = 0; i < count; ++i) {
    console_write(" ");
    console_write(words[i].name);
    console_write("=0x");
    log_hexadecimal(words[i].value);
  }
  console_write("\n");
  console_end(firmware::kOwnBug);
}

}  // namespace krait::bare_metal

void krait_main() {
  using namespace krait::bare_metal;
  prepare_memory();
  paint_stack();
  start_ticks();
  console_end(run_application());
}
