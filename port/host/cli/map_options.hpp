// SPDX-License-Identifier: Apache-2.0
// The options of every command that reads maps: how the file is to be understood.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/import/import.hpp"

namespace krait::host {

struct MapOptions {
  std::string unknown = "map";
  std::string unit;
  std::string datum;

  void add(CLI::App& command);
  ImportOptions read() const;                  // throws InputError
  std::vector<std::string> arguments() const;  // the same for krait-compile
  std::vector<std::string> given() const;      // the names of those on the command line

 private:
  CLI::App* command_ = nullptr;
};

}  // namespace krait::host
