// SPDX-License-Identifier: Apache-2.0
// What a program says of words on its command line that it does not understand.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace krait::host {

// The parser's line; in plain words that of an option that is given more than once.
inline std::string line_of(const CLI::ParseError& error) {
  const std::string line = error.what();
  const std::size_t counted = line.find(": At Most 1 required but received");
  return counted == std::string::npos ? line : line.substr(0, counted) + " is given more than once: give it once";
}

}  // namespace krait::host
