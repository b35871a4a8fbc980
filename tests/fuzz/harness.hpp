// SPDX-License-Identifier: Apache-2.0
// One harness an input: each reads bytes as libFuzzer hands them over. Linked with libFuzzer or AFL++'s driver it is
// fuzzed, linked with standalone.cpp it runs on files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Returns 0. Aborts on a finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

// Only where a harness knows its input's structure: changes data in place, at most `most` bytes; the new size.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

namespace krait::fuzz {

// A finding: what must hold does not.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: %s\n", what);
  std::abort();
}

}  // namespace krait::fuzz
