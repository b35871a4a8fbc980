// SPDX-License-Identifier: Apache-2.0
// One harness an input: each reads bytes as libFuzzer hands them over. Linked with libFuzzer or AFL++'s driver it is
// fuzzed, linked with standalone.cpp it runs on files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

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

// A place that a harness's corpus must lead to: standalone.cpp counts how many of its files do.
class Landmark {
 public:
  explicit Landmark(std::string name) : name_(std::move(name)), next_(first_) { first_ = this; }
  Landmark(const Landmark&) = delete;
  Landmark& operator=(const Landmark&) = delete;

  void reach() { ++times_; }

  const std::string& name() const { return name_; }
  unsigned long times() const { return times_; }
  const Landmark* next() const { return next_; }
  static const Landmark* first() { return first_; }

 private:
  static inline const Landmark* first_ = nullptr;

  std::string name_;
  unsigned long times_ = 0;
  const Landmark* next_;
};

// What becomes of inputs of one kind.
struct Outcomes {
  explicit Outcomes(const std::string& kind) : accepted(kind + ", accepted"), refused(kind + ", refused") {}

  Landmark accepted, refused;
};

}  // namespace krait::fuzz
