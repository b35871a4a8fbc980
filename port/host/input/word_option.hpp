// SPDX-License-Identifier: Apache-2.0
// Options of a program that take a word, or one of a few.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

namespace krait::host {

// "a, b or c", of two words or more.
inline std::string alternatives(const std::vector<std::string>& words) {
  std::string text = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) text += (i + 1 < words.size() ? ", " : " or ") + words[i];
  return text;
}

// Refuses the empty text, which an unset variable of a shell leaves: it would stand for the default.
inline CLI::Validator not_empty() {
  return {[](const std::string& text) { return std::string(text.empty() ? "give a value, this one is empty" : ""); },
          ""};
}

// Lets an option take one of the words only; the help lists them.
inline CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto check = [words](const std::string& text) -> std::string {
    if (std::find(words.begin(), words.end(), text) != words.end()) return {};
    return "give " + alternatives(words) + ", not " + text;
  };
  return {check, CLI::IsMember(words).get_description(), "word"};
}

}  // namespace krait::host
