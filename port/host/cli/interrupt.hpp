// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a wish: what runs ends cleanly with what there is. A second one ends the program at once.
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

}  // namespace krait::host
