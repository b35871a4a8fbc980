// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace krait::test {

// How much a test does: `thorough` where the environment has KRAIT_LONG_TESTS=1, `quick` elsewhere.
inline std::uint64_t by_length(std::uint64_t quick, std::uint64_t thorough) {
  const char* asked = std::getenv("KRAIT_LONG_TESTS");
  return asked != nullptr && std::string_view(asked) == "1" ? thorough : quick;
}

}  // namespace krait::test
