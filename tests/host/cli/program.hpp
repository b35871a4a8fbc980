// SPDX-License-Identifier: Apache-2.0
// Runs the built programs as a user does, in a folder of the test's own.
#pragma once

#include <gmock/gmock.h>

#include <chrono>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "host/scratch.hpp"

namespace krait::host {

struct Outcome {
  int code;            // exit code, or minus the number of the signal that ended it
  std::string output;  // standard output
  std::string errors;  // standard error
};

// Runs a program in `directory` with that as its working directory.
Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::filesystem::path& directory);

// The same; sends SIGINT once the program has run for so long.
Outcome run_and_interrupt(const std::string& program, const std::vector<std::string>& arguments,
                          const std::filesystem::path& directory, std::chrono::milliseconds after);

// The same with standard error on a terminal of the test's own; `errors` is what it showed.
Outcome run_on_terminal(const std::string& program, const std::vector<std::string>& arguments,
                        const std::filesystem::path& directory);

std::string read_text(const std::filesystem::path& path);

// A folder with room.json: x from -12 to 20 m, y from 0 to 10 m, a wall at x = 10 with a door of 2 m in its middle,
// start "west" at (3, 5), start "north" at (3, 8), goals "east" at (17, 5) and "south" at (17, 2); room.krait is
// compiled from it.
class CliTest : public ScratchTest {
 protected:
  CliTest();

  // krait with these arguments.
  Outcome krait(const std::vector<std::string>& arguments) const;

  // Runs krait and expects exit code 2, nothing on standard output, one line on standard error that begins with
  // "krait" and holds `mention`, and no file more or less than before.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& mention) const;

  // Expects exit code 0 and no complaint.
  void expect_done(const std::vector<std::string>& arguments) const;

  nlohmann::ordered_json json(const std::string& name) const;

  std::set<std::string> files() const;
};

}  // namespace krait::host
