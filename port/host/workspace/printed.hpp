// SPDX-License-Identifier: Apache-2.0
// Numbers in text, in the forms of std::printf.
#pragma once

#include <charconv>
#include <cstdio>
#include <string>

namespace krait::host {

// What std::printf would print, however long it is.
template <class... Values>
std::string printed(const char* form, Values... values) {
  char line[256];
  const int printed = std::snprintf(line, sizeof line, form, values...);
  const std::size_t length = printed > 0 ? static_cast<std::size_t>(printed) : 0;
  if (length < sizeof line) return {line, length};
  std::string text(length, '\0');
  (void)std::snprintf(text.data(), length + 1, form, values...);
  return text;
}

// "1 way", "2 ways".
inline std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// A float as people write it: 0.8, not the nearest float's 0.800000011920929.
inline double decimal(float value) {
  char text[32];
  double number = 0;
  std::from_chars(text, std::to_chars(text, text + sizeof text, value).ptr, number);
  return number;
}

}  // namespace krait::host
