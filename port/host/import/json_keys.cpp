// SPDX-License-Identifier: Apache-2.0
#include "host/import/json_keys.hpp"

#include <algorithm>

#include "host/import/format.hpp"

namespace krait::host {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

// After the quote that ends the string that begins at `begin`.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  for (std::size_t i = begin + 1; i < text.size(); ++i) {
    if (text[i] == '\\') {
      i += 1;
    } else if (text[i] == '"') {
      return i + 1;
    }
  }
  return text.size();
}

bool followed_by_colon(std::string_view text, std::size_t end) {
  const std::size_t next = text.find_first_not_of(kSpace, end);
  return next != std::string_view::npos && text[next] == ':';
}

// YAML's: without quotes.
bool begins_with_plain_key(std::string_view text, std::string_view key) {
  const std::size_t begin = text.find_first_not_of(kSpace);
  return begin != std::string_view::npos && text.substr(begin).starts_with(key) &&
         followed_by_colon(text, begin + key.size());
}

}  // namespace

bool is_json_object(std::string_view text) {
  const std::size_t first = text_begin(text);
  return first != std::string_view::npos && text[first] == '{';
}

bool has_top_json_key(std::string_view text, std::string_view key) {
  if (!is_json_object(text)) return false;
  int depth = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"') {
      const std::size_t end = end_of_string(text, i);
      const bool same = end - i == key.size() + 2 && text.substr(i + 1, key.size()) == key;
      if (depth == 1 && same && followed_by_colon(text, end)) return true;
      i = end;
      continue;
    }
    if (c == '{' || c == '[') depth += 1;
    if (c == '}' || c == ']') depth -= 1;
    if (depth == 1 && (c == '{' || c == ',') && begins_with_plain_key(text.substr(i + 1), key)) return true;
    i += 1;
  }
  return false;
}

}  // namespace krait::host
