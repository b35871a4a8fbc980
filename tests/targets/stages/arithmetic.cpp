// SPDX-License-Identifier: Apache-2.0
// Random numbers, and the elementary functions swept over the floats' bits.
#include <cmath>

#include "base/random.hpp"
#include "stages.hpp"

namespace krait::stages {
namespace {

void random_numbers(const firmware::Board& board) {
  Hash hash;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    detail::Random random(seed * 0x9E3779B97F4A7C15ULL);
    for (std::uint32_t i = 1; i <= 256; ++i) {
      hash.add(random.bits());
      hash.add(random.below(i));
      hash.add(random.unit());
    }
  }
  report(board, {"random"}, hash);
}

// Calls visit(x) for positive floats from `first` to `last`, `count` of them, evenly spaced in their bits: denormals
// and every binade alike.
template <class Visit>
void sweep(float first, float last, std::uint32_t count, Visit visit) {
  const auto low = std::bit_cast<std::uint32_t>(first);
  const std::uint32_t stride = (std::bit_cast<std::uint32_t>(last) - low) / count;
  for (std::uint32_t i = 0; i <= count; ++i) visit(std::bit_cast<float>(low + i * stride));
}

constexpr float kDenormal = 0x1p-149F;
constexpr float kLargest = 0x1.FFFFFEp127F;
constexpr std::uint32_t kDense = 10'007;

void sines(const firmware::Board& board) {
  Hash hash;
  const auto add = [&](float x) {
    const SinCos angle = math::sin_cos(x);
    hash.add(angle.sin);
    hash.add(angle.cos);
  };
  const auto both = [&](float x) {
    add(x);
    add(-x);
  };
  sweep(kDenormal, kMaxAngle, kDense, both);
  sweep(0.125F, 8.0F, kDense, both);  // where robots turn
  add(2.0F * kMaxAngle);
  report(board, {"sin_cos"}, hash);
}

void arctangents(const firmware::Board& board) {
  Hash hash;
  sweep(kDenormal, 1e30F, kDense, [&](float x) {
    hash.add(math::atan2(x, 1.0F));
    hash.add(math::atan2(-x, -1.0F));
    hash.add(math::atan2(1.0F, x));
    hash.add(math::wrap_angle(x <= kMaxAngle ? x : 0.0F));
  });
  hash.add(math::atan2(0.0F, 0.0F));
  report(board, {"atan2"}, hash);
}

void logarithms(const firmware::Board& board) {
  Hash hash;
  sweep(0x1p-126F, kLargest, kDense, [&](float x) { hash.add(math::log(x)); });
  sweep(0.5F, 2.0F, kDense, [&](float x) { hash.add(math::log(x)); });
  report(board, {"log"}, hash);
}

void square_roots(const firmware::Board& board) {
  Hash hash;
  sweep(kDenormal, kLargest, kDense, [&](float x) {
    hash.add(std::sqrt(x));
    hash.add(1.0F / x);
  });
  detail::Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const float x = spread(random, 100.0F);
    const float y = spread(random, 100.0F);
    hash.add(length({x, y}));
    hash.add(x / y);
    hash.add(dot({x, y}, {y, -x}));  // 0 unless fused
  }
  report(board, {"sqrt"}, hash);
}

}  // namespace

void arithmetic(const firmware::Board& board) {
  random_numbers(board);
  sines(board);
  arctangents(board);
  logarithms(board);
  square_roots(board);
}

}  // namespace krait::stages
