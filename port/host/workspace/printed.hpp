// SPDX-License-Identifier: Apache-2.0
// Numbers in text, in the forms of std::printf.
#pragma once

#include <cstdio>
#include <string>

namespace krait::host {

// What std::printf would print, however long it is.
template <class... Values>
std::string printed(const char* form, Values... values) {
  const int length = std::snprintf(nullptr, 0, form, values...);
  std::string text(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  (void)std::snprintf(text.data(), text.size() + 1, form, values...);
  return text;
}

}  // namespace krait::host
