// SPDX-License-Identifier: Apache-2.0
// Runs krait-compile, the scene compiler: a program of its own (GPL) that lies beside this one.
#pragma once

#include <string>
#include <vector>

namespace krait::host {

// The path of krait-compile. `program` is argv[0], for systems that do not tell where the program lies.
std::string compiler_path(const std::string& program);

// Becomes krait-compile with these arguments. Throws InputError where it cannot be run.
[[noreturn]] void become_compiler(const std::string& compiler, std::vector<std::string> arguments);

// Runs krait-compile on the map with further options of its own and returns the scene file that it makes. The bytes
// come through a pipe, so that no temporary file is left behind however this program ends; krait-compile ends with it.
// Warnings go to standard error. Where it fails, it has said so there: throws Exit with its exit code; or InputError
// where it cannot be run or is ended by a signal.
std::string run_compiler(const std::string& compiler, const std::string& map, std::vector<std::string> options);

}  // namespace krait::host
