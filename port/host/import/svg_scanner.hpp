// SPDX-License-Identifier: Apache-2.0
// The numbers and letters of an SVG attribute.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace krait::host {

class SvgScanner {
 public:
  using Fail = std::function<void(const std::string& what)>;  // throws InputError with the attribute's place

  SvgScanner(std::string_view text, Fail fail) : rest_(text), fail_(std::move(fail)) {}

  bool done();              // nothing is left but white space and commas
  bool at_number();         // a number comes next
  double number();          // of a magnitude of at most 1e15
  bool flag();              // 0 or 1, which need nothing between them and what follows
  char letter();            // one letter
  std::string_view word();  // letters, maybe none
  std::string_view unit();  // letters or % that follow a number at once
  void expect(char c);

  [[noreturn]] void fail(const std::string& what) const;

 private:
  void skip_separators();
  std::string next_text() const;

  std::string_view rest_;
  Fail fail_;
};

}  // namespace krait::host
