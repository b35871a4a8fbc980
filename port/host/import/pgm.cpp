// SPDX-License-Identifier: Apache-2.0
// Netpbm's grey maps: P2 (numbers as text) and P5 (bytes, or two bytes a pixel where the maximum is over 255).
#include <cctype>

#include "host/import/image.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {
namespace {

class Reader {
 public:
  Reader(const std::string& content, const std::string& file) : content_(content), file_(file), offset_(2) {}

  // A decimal number after white space and comments; most bounds it.
  std::uint32_t number(std::uint32_t most, const char* what) {
    skip_space();
    std::uint64_t value = 0;
    const std::size_t first = offset_;
    while (offset_ < content_.size() && std::isdigit(static_cast<unsigned char>(content_[offset_])) != 0) {
      value = value * 10 + static_cast<std::uint64_t>(content_[offset_++] - '0');
      if (value > most) fail(std::string(what) + " is over " + std::to_string(most));
    }
    if (offset_ == first) fail(offset_ == content_.size() ? "ends early" : std::string(what) + " is not a number");
    return static_cast<std::uint32_t>(value);
  }

  void skip_one_space() {
    if (offset_ == content_.size() || !space(content_[offset_])) fail("the header does not end");
    offset_ += 1;
  }

  void skip_space() {
    while (offset_ < content_.size() && (space(content_[offset_]) || content_[offset_] == '#')) {
      if (content_[offset_] == '#') {
        while (offset_ < content_.size() && content_[offset_] != '\n') offset_ += 1;
      } else {
        offset_ += 1;
      }
    }
  }

  std::uint32_t byte() { return static_cast<unsigned char>(content_[offset_++]); }
  std::size_t left() const { return content_.size() - offset_; }
  [[noreturn]] void fail(const std::string& what) const { throw InputError(file_ + ": is not a sound PGM: " + what); }

 private:
  static bool space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

  const std::string& content_;
  const std::string& file_;
  std::size_t offset_;
};

void require_left(const Reader& reader, std::uint64_t needed) {
  if (reader.left() < needed) {
    reader.fail("the header needs " + std::to_string(needed) + " bytes of pixels, the file has " +
                std::to_string(reader.left()));
  }
}

void require_end(Reader& reader) {
  reader.skip_space();
  if (reader.left() > 0) reader.fail(std::to_string(reader.left()) + " bytes follow the last pixel");
}

}  // namespace

bool is_pgm(const std::string& content) { return content.starts_with("P2") || content.starts_with("P5"); }

Image decode_pgm(const std::string& content, const std::string& file) {
  constexpr std::uint32_t kMaxSide = 1U << 30;
  constexpr std::uint32_t kMaxValue = 65535;
  Reader reader(content, file);
  const bool binary = content[1] == '5';
  const std::uint32_t columns = reader.number(kMaxSide, "the width");
  const std::uint32_t rows = reader.number(kMaxSide, "the height");
  const std::uint32_t most = reader.number(kMaxValue, "the maximum");
  require_cells(columns, rows, file);
  if (most == 0) reader.fail("the maximum is 0");
  if (binary) reader.skip_one_space();
  const bool wide = binary && most > 255;
  const std::uint64_t count = std::uint64_t{columns} * rows;
  require_left(reader, wide ? 2 * count : count);  // a number of P2 has at least one digit

  Image image{static_cast<int>(columns), static_cast<int>(rows), false, {}};
  image.pixels.resize(count);
  for (Pixel& pixel : image.pixels) {
    std::uint32_t value = 0;
    if (binary) {
      value = reader.byte();
      if (wide) value = value << 8 | reader.byte();
      if (value > most) reader.fail("a pixel is over " + std::to_string(most));
    } else {
      value = reader.number(most, "a pixel");
    }
    const auto grey = static_cast<std::uint16_t>((value * kMaxValue + most / 2) / most);
    pixel = {grey, grey, grey, 65535};
  }
  require_end(reader);
  return image;
}

}  // namespace krait::host
