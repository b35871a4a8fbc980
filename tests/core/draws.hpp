// SPDX-License-Identifier: Apache-2.0
// Random numbers for tests, the same with every standard library.
#pragma once

#include <cstdint>
#include <random>

namespace krait::test {

inline double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}
inline float uniform_float(std::mt19937& random, double low, double high) {
  return static_cast<float>(uniform(random, low, high));
}
// 0 … count - 1.
inline std::uint32_t below(std::mt19937& random, std::uint64_t count) {
  return static_cast<std::uint32_t>(random() % count);
}

}  // namespace krait::test
