// SPDX-License-Identifier: Apache-2.0
// The picture of a map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace krait::host {

inline constexpr std::uint64_t kMaxCells = 64U << 20;  // of a map

// Throws InputError naming the file where a map has no cell or more than kMaxCells.
void require_cells(std::uint64_t columns, std::uint64_t rows, const std::string& file);

struct Pixel {  // 0 dark, 65535 bright; alpha 65535 opaque
  std::uint16_t red;
  std::uint16_t green;
  std::uint16_t blue;
  std::uint16_t alpha;
};

struct Image {
  int columns = 0;
  int rows = 0;
  bool has_alpha = false;     // the file's pixels have an alpha channel or a transparent colour
  std::vector<Pixel> pixels;  // row-major, the top row first
  bool lossy = false;         // the file's compression changes pixels

  const Pixel& at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  }
};

bool is_image(const std::string& content);

// PGM (P2, P5, up to 16 bits), PNG (every kind), BMP (without compression) or JPEG, by content. Throws InputError
// naming the file.
Image read_image(const std::string& path);
Image decode_image(const std::string& content, const std::string& file);

Image decode_pgm(const std::string& content, const std::string& file);
Image decode_png(const std::string& content, const std::string& file);
Image decode_bmp(const std::string& content, const std::string& file);
Image decode_jpeg(const std::string& content, const std::string& file);
bool is_pgm(const std::string& content);
bool is_png(const std::string& content);
bool is_bmp(const std::string& content);
bool is_jpeg(const std::string& content);

}  // namespace krait::host
