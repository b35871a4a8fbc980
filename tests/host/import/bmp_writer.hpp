// SPDX-License-Identifier: Apache-2.0
// Writes small bitmaps of every kind, also wrong ones.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace krait::host {

struct BmpKind {
  std::uint32_t bits;
  std::int32_t width;
  std::int32_t height;                 // negative: the top row first
  std::vector<std::uint32_t> palette;  // 0xRRGGBB
};

inline std::string little_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i));
  return text;
}

// The rows hold packed pixels in the file's order; they are padded here.
inline std::string bmp(const BmpKind& kind, const std::vector<std::string>& rows) {
  std::string palette;
  for (const std::uint32_t color : kind.palette) palette += little_endian(color, 4);
  std::string pixels;
  for (const std::string& row : rows) pixels += row + std::string((4 - row.size() % 4) % 4, '\0');
  const std::string info = little_endian(40, 4) + little_endian(static_cast<std::uint32_t>(kind.width), 4) +
                           little_endian(static_cast<std::uint32_t>(kind.height), 4) + little_endian(1, 2) +
                           little_endian(kind.bits, 2) + std::string(16, '\0') +
                           little_endian(static_cast<std::uint32_t>(kind.palette.size()), 4) + little_endian(0, 4);
  const auto offset = static_cast<std::uint32_t>(14 + info.size() + palette.size());
  return "BM" + little_endian(offset + static_cast<std::uint32_t>(pixels.size()), 4) + little_endian(0, 4) +
         little_endian(offset, 4) + info + palette + pixels;
}

}  // namespace krait::host
