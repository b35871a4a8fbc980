// SPDX-License-Identifier: Apache-2.0
// The median of many counts in little memory, to within 2^-kBits: four thousandths with 8, in 25 KB.
#pragma once

#include <bit>
#include <cstdint>

namespace krait::bench {

template <std::uint32_t kBits>
class Median {
 public:
  void add(std::uint32_t value, std::uint32_t weight = 1) {
    if (value > worst_) worst_ = value;
    buckets_[bucket(value)] += weight;
    total_ += weight;
  }

  // The least value of the bucket that holds it; 0 of none.
  std::uint32_t median() const {
    std::uint32_t chosen = 0;
    for (std::uint64_t seen = buckets_[0]; 2 * seen < total_; seen += buckets_[chosen]) ++chosen;
    return lowest(chosen);
  }
  std::uint32_t worst() const { return worst_; }
  std::uint64_t count() const { return total_; }

 private:
  static constexpr std::uint32_t kBuckets = 1U << kBits;  // a power of two; one a value below it

  static std::uint32_t bucket(std::uint32_t value) {
    if (value < kBuckets) return value;
    const auto shift = static_cast<std::uint32_t>(std::bit_width(value)) - (kBits + 1);
    return shift * kBuckets + (value >> shift);
  }
  static std::uint32_t lowest(std::uint32_t bucket) {
    if (bucket < 2 * kBuckets) return bucket;
    return (kBuckets + bucket % kBuckets) << (bucket / kBuckets - 1);
  }

  std::uint32_t buckets_[(32 - kBits + 1) * kBuckets] = {};
  std::uint64_t total_ = 0;
  std::uint32_t worst_ = 0;
};

}  // namespace krait::bench
