// SPDX-License-Identifier: Apache-2.0
// Where this checkout's sources and its built programs are. One source alone knows: what names these folders in a
// definition of the compiler's would be compiled anew in every checkout, whatever the compiler's cache has.
#pragma once

#include <string>

namespace krait::test {

// A path below the project's folder; it itself for "".
std::string source_path(const std::string& below);

// A program of the build that the test is of; the folder of all for "".
std::string program_path(const std::string& name);

}  // namespace krait::test
