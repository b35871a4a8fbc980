// SPDX-License-Identifier: Apache-2.0
#include "krait/plan/plan.hpp"

#include <bit>

namespace krait {

void Fnv::add(const float* values, int count) {
  for (int i = 0; i < count; ++i) {
    const auto bits = std::bit_cast<std::uint32_t>(values[i]);
    for (unsigned shift = 0; shift < 32; shift += 8) value_ = (value_ ^ ((bits >> shift) & 0xFFU)) * 0x100000001B3ULL;
  }
}

}  // namespace krait
