// SPDX-License-Identifier: Apache-2.0
// Changes a scene where it matters: whole fields and elements, with values at the edges of their ranges, instead of
// single bits; and makes length and check sum right again, so that a change gets past the first test.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include "krait/format.hpp"

namespace krait::fuzz {

inline std::uint32_t crc32(const std::uint8_t* data, std::size_t size) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= data[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) * 0xEDB88320U);
  }
  return crc ^ 0xFFFFFFFFU;
}

// Magic, version, length and check sum become right.
inline void repair(std::uint8_t* data, std::size_t size) {
  if (size < sizeof(format::Header)) return;
  format::Header header;
  std::memcpy(&header, data, sizeof header);
  std::memcpy(header.magic, format::kMagic, sizeof header.magic);
  header.version = format::kVersion;
  header.reserved = 0;
  header.total_bytes = static_cast<std::uint32_t>(size);
  constexpr std::size_t kFirst = offsetof(format::Header, origin_x);
  header.crc32 = crc32(data + kFirst, size - kFirst);
  std::memcpy(data, &header, sizeof header);
}

class SceneMutator {
 public:
  SceneMutator(std::uint8_t* data, std::size_t size, unsigned seed) : data_(data), size_(size), random_(seed) {}

  void run() {
    if (size_ < sizeof(format::Header)) return;
    std::memcpy(&header_, data_, sizeof header_);
    for (std::uint32_t changes = 1 + below(3); changes > 0; --changes) change();
    repair(data_, size_);
  }

 private:
  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(random_() % n); }

  void change() {
    constexpr std::size_t kFields = (sizeof(format::Header) - offsetof(format::Header, origin_x)) / 4;
    if (below(5) == 0) return change_word(offsetof(format::Header, origin_x) + 4 * below(kFields));
    const std::size_t section = below(format::kSectionCount);
    const std::size_t first = header_.section_offsets[section];
    const std::size_t end =
        section + 1 < format::kSectionCount ? header_.section_offsets[section + 1] : header_.total_bytes;
    if (first >= end || end > size_) return change_word(4 * below(size_ / 4));
    const std::size_t at = first + below(end - first);
    switch (below(4)) {
      case 0:
        return change_word(at / 4 * 4);
      case 1:
        return change_half(at / 2 * 2);
      case 2:
        data_[at] = static_cast<std::uint8_t>(below(2) == 0 ? below(256) : data_[at] + below(9) - 4);
        return;
      default:
        return swap(at / 4 * 4, (first + below(end - first)) / 4 * 4);
    }
  }

  void change_word(std::size_t at) {
    if (at + 4 > size_) return;
    std::uint32_t word = 0;
    std::memcpy(&word, data_ + at, sizeof word);
    float real = 0;
    std::memcpy(&real, data_ + at, sizeof real);
    static constexpr float kReals[] = {0.0F,
                                       -0.0F,
                                       1.0F,
                                       format::kGrid,
                                       -format::kGrid,
                                       format::kMaxCoordinate,
                                       -format::kMaxCoordinate,
                                       4000.0F,
                                       5e9F,
                                       std::numeric_limits<float>::max(),
                                       std::numeric_limits<float>::denorm_min(),
                                       std::numeric_limits<float>::infinity(),
                                       -std::numeric_limits<float>::infinity(),
                                       std::numeric_limits<float>::quiet_NaN()};
    static constexpr std::uint32_t kWords[] = {0,      1,       2,          3,          0x7FFF,     0xFFFE,
                                               0xFFFF, 0x10000, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF};
    switch (below(6)) {
      case 0:
        word = kWords[below(std::size(kWords))];
        break;
      case 1:
        word += below(17) - 8;
        break;
      case 2:
        real = kReals[below(std::size(kReals))];
        std::memcpy(&word, &real, sizeof word);
        break;
      case 3:  // stays on the grid
        real += format::kGrid * static_cast<float>(static_cast<int>(below(8193)) - 4096);
        std::memcpy(&word, &real, sizeof word);
        break;
      case 4:
        word ^= 1U << below(32);
        break;
      default:
        word = static_cast<std::uint32_t>(random_());
    }
    std::memcpy(data_ + at, &word, sizeof word);
  }

  void change_half(std::size_t at) {
    if (at + 2 > size_) return;
    std::uint16_t half = 0;
    std::memcpy(&half, data_ + at, sizeof half);
    half = static_cast<std::uint16_t>(below(3) == 0 ? below(65536) : half + below(9) - 4);
    std::memcpy(data_ + at, &half, sizeof half);
  }

  void swap(std::size_t a, std::size_t b) {
    if (a + 4 > size_ || b + 4 > size_) return;
    std::uint8_t word[4];
    std::memcpy(word, data_ + a, sizeof word);
    std::memmove(data_ + a, data_ + b, sizeof word);
    std::memcpy(data_ + b, word, sizeof word);
  }

  std::uint8_t* data_;
  std::size_t size_;
  std::mt19937 random_;
  format::Header header_{};
};

}  // namespace krait::fuzz
