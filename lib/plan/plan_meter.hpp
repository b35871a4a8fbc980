// SPDX-License-Identifier: Apache-2.0
// Length and hash of a plan, measured while it is driven.
#pragma once

#include <cstdint>

namespace krait::detail {

// Folds floats into an FNV-1a 64 hash, each as 4 little-endian bytes.
class Fnv {
 public:
  void add(const float* values, int count);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325ULL;
};

struct PlanMeasures {
  std::uint32_t steps = 0;
  float length = 0.0F;     // metres, of the line through the positions
  std::uint64_t hash = 0;  // FNV-1a 64 over s0, u0, s1, u1, …, sL
};

// Measures a plan step by step, in the order in which it is driven.
class PlanMeter {
 public:
  // One step; arrays of state_size and control_size floats.
  void add(const float* state, int state_size, const float* control, int control_size, const float* next);

  float length() const { return measures_.length; }  // metres, so far

  // The measures of the plan that ends with `state`.
  PlanMeasures end(const float* state, int state_size);

 private:
  PlanMeasures measures_;
  Fnv hash_;
};

}  // namespace krait::detail
