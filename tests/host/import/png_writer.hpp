// SPDX-License-Identifier: Apache-2.0
// Writes small PNGs of every kind.
#pragma once

#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

namespace krait::host {

inline void append(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

struct PngKind {
  int color_type;
  int bit_depth;
  bool interlaced = false;
  bool transparent_key = false;  // tRNS: palette entry 1, or grey value 1, is transparent
};

// The rows hold packed samples in PNG's byte order. The palette is four colours (10 i, 20 i, 30 i).
inline std::string encode(const PngKind& kind, std::uint32_t width, std::vector<std::string> rows) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_IHDR(png, info, width, static_cast<std::uint32_t>(rows.size()), kind.bit_depth, kind.color_type,
               kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  const png_color palette[4] = {{0, 0, 0}, {10, 20, 30}, {20, 40, 60}, {30, 60, 90}};
  if (kind.color_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 4);
  const png_byte alphas[2] = {255, 0};
  png_color_16 key = {};
  key.gray = 1;
  if (kind.transparent_key) png_set_tRNS(png, info, alphas, 2, &key);
  std::vector<png_bytep> pointers;
  for (std::string& row : rows) pointers.push_back(reinterpret_cast<png_bytep>(row.data()));
  png_set_rows(png, info, pointers.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

}  // namespace krait::host
