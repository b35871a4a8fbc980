#include "krait/plan.hpp"

#include <bit>

#include "krait/math.hpp"

namespace krait {
namespace {

std::uint64_t fnv(std::uint64_t hash, const float* values, int count) {
  for (int i = 0; i < count; ++i) {
    const auto bits = std::bit_cast<std::uint32_t>(values[i]);
    for (unsigned shift = 0; shift < 32; shift += 8) hash = (hash ^ ((bits >> shift) & 0xFFU)) * 0x100000001B3ULL;
  }
  return hash;
}

float* append(float* out, const float* values, int count) {
  for (int i = 0; i < count; ++i) *out++ = values[i];
  return out;
}

}  // namespace

float Plan::length() const {
  float sum = 0.0F;
  for (std::uint32_t i = 0; i < steps(); ++i) {
    const float* a = state(i);
    const float* b = state(i + 1);
    sum += krait::length(Vec2{b[0] - a[0], b[1] - a[1]});
  }
  return sum;
}

std::uint64_t Plan::hash() const {
  if (empty()) return 0;
  std::uint64_t hash = fnv(0xCBF29CE484222325ULL, state(0), state_size_);
  for (std::uint32_t i = 0; i < steps(); ++i) {
    hash = fnv(hash, control(i), control_size_);
    hash = fnv(hash, state(i + 1), state_size_);
  }
  return hash;
}

void Plan::copy(float* states, float* controls) const {
  if (empty()) return;
  states = append(states, state(0), state_size_);
  for (std::uint32_t i = 0; i < steps(); ++i) {
    controls = append(controls, control(i), control_size_);
    states = append(states, state(i + 1), state_size_);
  }
}

}  // namespace krait
