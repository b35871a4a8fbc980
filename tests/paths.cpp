// SPDX-License-Identifier: Apache-2.0
#include "paths.hpp"

namespace krait::test {

std::string source_path(const std::string& below) { return KRAIT_SOURCE_DIR "/" + below; }

std::string program_path(const std::string& name) { return KRAIT_BIN_DIR "/" + name; }

}  // namespace krait::test
