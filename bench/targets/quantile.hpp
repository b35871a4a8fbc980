// The median of many counts in little memory, exactly: what is measured is repeatable, so it is measured twice.
#pragma once

#include <bit>
#include <cstdint>

namespace krait::bench {

// The first pass finds the bucket that holds the median, 64 buckets a power of two; the second cuts that bucket into
// kCells. Exact where the bucket is no wider: below 2^18.
class Median {
 public:
  void add(std::uint32_t value, std::uint32_t weight = 1) {
    if (value > worst_) worst_ = value;
    if (!second_) {
      buckets_[bucket(value)] += weight;
      total_ += weight;
    } else if (value >= low_ && value - low_ < width_) {
      cells_[(value - low_) / cell_] += weight;
    }
  }

  // Ends the first pass.
  void narrow() {
    std::uint32_t chosen = 0;
    before_ = 0;
    while (before_ + buckets_[chosen] < half()) before_ += buckets_[chosen++];
    low_ = lowest(chosen);
    width_ = lowest(chosen + 1) - low_;
    cell_ = width_ < kCells ? 1 : width_ / kCells;
    second_ = true;
  }

  // After the second pass.
  std::uint32_t median() const {
    std::uint32_t cell = 0;
    for (std::uint32_t seen = before_ + cells_[0]; seen < half();) seen += cells_[++cell];
    return low_ + cell * cell_;
  }
  std::uint32_t worst() const { return worst_; }

 private:
  static constexpr std::uint32_t kBuckets = 64;  // a power of two
  static constexpr std::uint32_t kCells = 4096;

  std::uint32_t half() const { return (total_ + 1) / 2; }

  static std::uint32_t bucket(std::uint32_t value) {
    if (value < kBuckets) return value;
    const auto shift = static_cast<std::uint32_t>(std::bit_width(value)) - 7;
    return shift * kBuckets + (value >> shift);
  }
  static std::uint32_t lowest(std::uint32_t bucket) {
    if (bucket < 2 * kBuckets) return bucket;
    return (kBuckets + bucket % kBuckets) << (bucket / kBuckets - 1);
  }

  std::uint32_t buckets_[27 * kBuckets] = {};
  std::uint32_t cells_[kCells] = {};
  std::uint32_t total_ = 0;
  std::uint32_t before_ = 0;  // weight below the median's bucket
  std::uint32_t low_ = 0;
  std::uint32_t width_ = 0;
  std::uint32_t cell_ = 1;
  std::uint32_t worst_ = 0;
  bool second_ = false;
};

}  // namespace krait::bench
