// SPDX-License-Identifier: Apache-2.0
// Options that name a file to be written.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace krait::host {

// Refuses the empty name, which an unset variable of a shell leaves, and -, which many programs take for standard
// output.
inline CLI::Validator output_name() {
  return CLI::Validator(
      [](const std::string& name) {
        if (name.empty()) return std::string("give a file name, this one is empty");
        return name == "-" ? std::string("give a file name; /dev/stdout is standard output") : std::string();
      },
      "");
}

}  // namespace krait::host
