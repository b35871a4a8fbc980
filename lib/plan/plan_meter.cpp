// SPDX-License-Identifier: Apache-2.0
#include "plan/plan_meter.hpp"

#include <bit>

#include "krait/geometry.hpp"

namespace krait::detail {

void Fnv::add(const float* values, int count) {
  for (int i = 0; i < count; ++i) {
    const auto bits = std::bit_cast<std::uint32_t>(values[i]);
    for (unsigned shift = 0; shift < 32; shift += 8) value_ = (value_ ^ ((bits >> shift) & 0xFFU)) * 0x100000001B3ULL;
  }
}

void PlanMeter::add(const float* state, int state_size, const float* control, int control_size, const float* next) {
  hash_.add(state, state_size);
  hash_.add(control, control_size);
  ++measures_.steps;
  measures_.length += krait::length(Vec2{next[0], next[1]} - Vec2{state[0], state[1]});
}

PlanMeasures PlanMeter::end(const float* state, int state_size) {
  hash_.add(state, state_size);
  measures_.hash = hash_.value();
  return measures_;
}

}  // namespace krait::detail
