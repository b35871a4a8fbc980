// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a wish: what runs ends cleanly with what there is. A second one ends the program at once. LastWord is for
// work that leaves nothing when it is stopped: one line, and the program ends.
#pragma once

namespace krait::host {

// While it lives, the first SIGINT is noted and no more; where SIGINT was ignored (nohup), it stays so. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool asked() const;

 private:
  void (*before_)(int);
};

// While it lives, SIGINT ends the program as it would without, after a line on standard error; where SIGINT was
// ignored, it stays so. One at a time, and not with an Interrupt.
class LastWord {
 public:
  explicit LastWord(const char* line);  // whose text stays
  ~LastWord();
  LastWord(const LastWord&) = delete;
  LastWord& operator=(const LastWord&) = delete;

 private:
  void (*before_)(int);
};

}  // namespace krait::host
