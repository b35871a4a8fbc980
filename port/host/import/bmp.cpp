// SPDX-License-Identifier: Apache-2.0
// Windows bitmaps without compression: 1, 4 and 8 bits with a palette, 24 and 32 bits with blue, green, red. Rows are
// padded to four bytes; the lowest comes first unless the height is negative. The fourth byte of 32 bits is not used.
#include <array>
#include <cstdlib>

#include "host/import/image.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

constexpr std::size_t kFileHeaderBytes = 14;
constexpr std::uint32_t kLeastInfoBytes = 40;
constexpr std::uint32_t kMostInfoBytes = 124;  // of the fifth version

struct Header {
  std::uint32_t pixels = 0;   // offset
  std::uint32_t palette = 0;  // offset
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  bool top_first = false;
  std::uint32_t bits = 0;    // of a pixel
  std::uint32_t colors = 0;  // of the palette
};

class Reader {
 public:
  Reader(const std::string& content, const std::string& file) : content_(content), file_(file) {}

  // Little-endian; throws where the file ends before.
  std::uint32_t number(std::size_t offset, std::size_t bytes) const {
    require(offset + bytes);
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value |= byte(offset + i) << (8 * i);
    return value;
  }

  std::uint32_t byte(std::size_t offset) const { return static_cast<unsigned char>(content_[offset]); }

  void require(std::uint64_t bytes) const {
    if (content_.size() >= bytes) return;
    fail("it needs " + std::to_string(bytes) + " bytes, the file has " + std::to_string(content_.size()));
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(file_ + ": is not a sound BMP: " + what); }

 private:
  const std::string& content_;
  const std::string& file_;
};

std::uint32_t read_bits(const Reader& reader) {
  const std::uint32_t bits = reader.number(28, 2);
  const std::uint32_t compression = reader.number(30, 4);
  if (compression != 0) {
    reader.fail("its pixels are compressed or masked (kind " + std::to_string(compression) +
                "); save it without compression, or as PNG");
  }
  for (const std::uint32_t known : {1U, 4U, 8U, 24U, 32U}) {
    if (bits == known) return bits;
  }
  reader.fail("pixels of " + std::to_string(bits) + " bits; known are 1, 4, 8, 24 and 32");
}

std::uint32_t read_colors(const Reader& reader, std::uint32_t bits) {
  if (bits > 8) return 0;
  const std::uint32_t most = 1U << bits;
  const std::uint32_t colors = reader.number(46, 4);
  if (colors > most)
    reader.fail("a palette of " + std::to_string(colors) + " colours; at most " + std::to_string(most));
  return colors == 0 ? most : colors;
}

Header read_header(const Reader& reader, const std::string& file) {
  const std::uint32_t info = reader.number(kFileHeaderBytes, 4);
  if (info < kLeastInfoBytes || info > kMostInfoBytes) {
    reader.fail("a header of " + std::to_string(info) + " bytes; known are 40 to 124");
  }
  const auto width = static_cast<std::int32_t>(reader.number(18, 4));
  const auto height = static_cast<std::int32_t>(reader.number(22, 4));
  if (width <= 0 || height == 0) reader.fail("it has no width or no height");
  Header header;
  header.columns = static_cast<std::uint32_t>(width);
  header.rows = static_cast<std::uint32_t>(std::abs(std::int64_t{height}));
  header.top_first = height < 0;
  require_cells(header.columns, header.rows, file);
  header.bits = read_bits(reader);
  header.colors = read_colors(reader, header.bits);
  header.palette = static_cast<std::uint32_t>(kFileHeaderBytes) + info;
  header.pixels = reader.number(10, 4);
  if (header.pixels < header.palette + 4 * header.colors) reader.fail("its pixels begin before its header's end");
  return header;
}

Pixel color_at(const Reader& reader, std::size_t offset) {
  const auto channel = [&](std::size_t i) { return static_cast<std::uint16_t>(257 * reader.byte(offset + i)); };
  return {channel(2), channel(1), channel(0), 65535};
}

std::vector<Pixel> read_palette(const Reader& reader, const Header& header) {
  std::vector<Pixel> palette(header.colors);
  reader.require(header.palette + 4 * header.colors);
  for (std::size_t i = 0; i < palette.size(); ++i) palette[i] = color_at(reader, header.palette + 4 * i);
  return palette;
}

// The most significant bits of a byte are its leftmost pixel.
Pixel pixel_at(const Reader& reader, const Header& header, const std::vector<Pixel>& palette, std::size_t row,
               std::uint32_t column) {
  if (header.bits > 8) return color_at(reader, row + std::size_t{column} * (header.bits / 8));
  const std::uint32_t first = column * header.bits;
  const std::uint32_t shift = 8 - header.bits - first % 8;
  const std::uint32_t index = reader.byte(row + first / 8) >> shift & ((1U << header.bits) - 1);
  if (index >= header.colors) reader.fail("a pixel has a colour that the palette has not");
  return palette[index];
}

}  // namespace

bool is_bmp(const std::string& content) { return content.starts_with("BM"); }

Image decode_bmp(const std::string& content, const std::string& file) {
  const Reader reader(content, file);
  const Header header = read_header(reader, file);
  const std::uint64_t row_bytes = (std::uint64_t{header.columns} * header.bits + 31) / 32 * 4;
  reader.require(header.pixels + header.rows * row_bytes);
  const std::vector<Pixel> palette = read_palette(reader, header);
  Image image{static_cast<int>(header.columns), static_cast<int>(header.rows), false, {}};
  image.pixels.reserve(std::size_t{header.columns} * header.rows);
  for (std::uint32_t i = 0; i < header.rows; ++i) {
    const std::uint32_t from_first = header.top_first ? i : header.rows - 1 - i;
    const std::size_t row = header.pixels + from_first * row_bytes;
    for (std::uint32_t column = 0; column < header.columns; ++column) {
      image.pixels.push_back(pixel_at(reader, header, palette, row, column));
    }
  }
  return image;
}

}  // namespace krait::host
