// SPDX-License-Identifier: Apache-2.0
// Every pixel format, written here by libpng or by hand, read back.
#include <gmock/gmock.h>

#include "../scratch.hpp"
#include "host/import/image.hpp"
#include "png_writer.hpp"

namespace krait::host::import_image_test {
namespace {

using testing::HasSubstr;

void expect_pixel(const Image& image, int column, int row, int red, int green, int blue, int alpha) {
  const Pixel& p = image.at(column, row);
  EXPECT_EQ(p.red, red);
  EXPECT_EQ(p.green, green);
  EXPECT_EQ(p.blue, blue);
  EXPECT_EQ(p.alpha, alpha);
}

Image decode(const PngKind& kind, std::uint32_t width, const std::vector<std::string>& rows) {
  return decode_png(encode(kind, width, rows), "m.png");
}

TEST(Png, Grey8) {
  const Image image = decode({PNG_COLOR_TYPE_GRAY, 8}, 2, {std::string("\0\xCD", 2), std::string("\xFE\xFF", 2)});
  ASSERT_EQ(image.columns, 2);
  ASSERT_EQ(image.rows, 2);
  EXPECT_FALSE(image.has_alpha);
  expect_pixel(image, 1, 0, 205 * 257, 205 * 257, 205 * 257, 65535);
  expect_pixel(image, 0, 1, 254 * 257, 254 * 257, 254 * 257, 65535);
}

TEST(Png, GreyOfOneTwoAndFourBits) {
  expect_pixel(decode({PNG_COLOR_TYPE_GRAY, 1}, 2, {"\x40"}), 1, 0, 65535, 65535, 65535, 65535);
  expect_pixel(decode({PNG_COLOR_TYPE_GRAY, 2}, 2, {"\x10"}), 1, 0, 85 * 257, 85 * 257, 85 * 257, 65535);
  expect_pixel(decode({PNG_COLOR_TYPE_GRAY, 4}, 2, {"\x0A"}), 1, 0, 170 * 257, 170 * 257, 170 * 257, 65535);
}

TEST(Png, Grey16KeepsEveryBit) {
  expect_pixel(decode({PNG_COLOR_TYPE_GRAY, 16}, 1, {"\x12\x34"}), 0, 0, 0x1234, 0x1234, 0x1234, 65535);
}

TEST(Png, GreyWithAlpha) {
  const Image image = decode({PNG_COLOR_TYPE_GRAY_ALPHA, 8}, 1, {"\x40\x80"});
  EXPECT_TRUE(image.has_alpha);
  expect_pixel(image, 0, 0, 0x4040, 0x4040, 0x4040, 0x8080);
}

TEST(Png, GreyWithATransparentValue) {
  const Image image = decode({PNG_COLOR_TYPE_GRAY, 8, false, true}, 2, {"\x01\x02"});
  EXPECT_TRUE(image.has_alpha);
  EXPECT_EQ(image.at(0, 0).alpha, 0);
  EXPECT_EQ(image.at(1, 0).alpha, 65535);
}

TEST(Png, RgbAndRgba) {
  const Image rgb = decode({PNG_COLOR_TYPE_RGB, 8}, 1, {"\x01\x02\x03"});
  EXPECT_FALSE(rgb.has_alpha);
  expect_pixel(rgb, 0, 0, 257, 514, 771, 65535);
  const Image rgba = decode({PNG_COLOR_TYPE_RGB_ALPHA, 8}, 1, {"\x01\x02\x03\xFE"});
  EXPECT_TRUE(rgba.has_alpha);
  expect_pixel(rgba, 0, 0, 257, 514, 771, 254 * 257);
}

TEST(Png, RgbAndRgbaOf16Bits) {
  expect_pixel(decode({PNG_COLOR_TYPE_RGB, 16}, 1, {"\x01\x02\x03\x04\x05\x06"}), 0, 0, 0x102, 0x304, 0x506, 65535);
  expect_pixel(decode({PNG_COLOR_TYPE_RGB_ALPHA, 16}, 1, {"\x01\x02\x03\x04\x05\x06\x07\x08"}), 0, 0, 0x102, 0x304,
               0x506, 0x708);
}

TEST(Png, Palette) {
  const Image image = decode({PNG_COLOR_TYPE_PALETTE, 8}, 2, {std::string("\x03\x00", 2)});
  EXPECT_FALSE(image.has_alpha);
  expect_pixel(image, 0, 0, 30 * 257, 60 * 257, 90 * 257, 65535);
  expect_pixel(decode({PNG_COLOR_TYPE_PALETTE, 2}, 2, {"\x20"}), 1, 0, 20 * 257, 40 * 257, 60 * 257, 65535);
}

TEST(Png, PaletteWithATransparentEntry) {
  const Image image = decode({PNG_COLOR_TYPE_PALETTE, 8, false, true}, 2, {"\x01\x02"});
  EXPECT_TRUE(image.has_alpha);
  expect_pixel(image, 0, 0, 2570, 5140, 7710, 0);
  EXPECT_EQ(image.at(1, 0).alpha, 65535);
}

TEST(Png, InterlacedReadsAsPlain) {
  std::vector<std::string> rows(13, std::string(11, ' '));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < rows[i].size(); ++k) rows[i][k] = static_cast<char>(i * 16 + k);
  }
  const Image image = decode({PNG_COLOR_TYPE_GRAY, 8, true}, 11, rows);
  for (int row = 0; row < 13; ++row) {
    for (int column = 0; column < 11; ++column) EXPECT_EQ(image.at(column, row).red, (row * 16 + column) * 257);
  }
}

TEST(Png, MayPackSomeHundredTimes) {
  const std::vector<std::string> rows(1000, std::string(1000, '\xFF'));
  EXPECT_LT(encode({PNG_COLOR_TYPE_GRAY, 8}, 1000, rows).size(), 4000U);
  expect_pixel(decode({PNG_COLOR_TYPE_GRAY, 8}, 1000, rows), 999, 999, 65535, 65535, 65535, 65535);
}

TEST(Png, TruncatedAtAnyLengthIsRefused) {
  const std::string bytes = encode({PNG_COLOR_TYPE_RGB, 8}, 2, {"abcdef", "ghijkl"});
  for (std::size_t length = 8; length < bytes.size(); ++length) {
    EXPECT_THAT(error_of([&] { decode_png(bytes.substr(0, length), "m.png"); }),
                HasSubstr("m.png: is not a sound PNG"));
  }
}

TEST(Png, AFlippedBitIsRefusedOrHarmless) {
  const std::string bytes = encode({PNG_COLOR_TYPE_RGB, 8}, 2, {"abcdef", "ghijkl"});
  for (std::size_t i = 8 * 8; i < 8 * bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i / 8] = static_cast<char>(damaged[i / 8] ^ (1 << (i % 8)));
    error_of([&] { decode_png(damaged, "m.png"); });  // no crash, no other exception
  }
}

// IHDR with sides of one's choice: only its CRC has to be right.
std::string with_size(std::string bytes, std::uint32_t width, std::uint32_t height) {
  for (int i = 0; i < 4; ++i) {
    bytes[static_cast<std::size_t>(16 + i)] = static_cast<char>(width >> (24 - 8 * i));
    bytes[static_cast<std::size_t>(20 + i)] = static_cast<char>(height >> (24 - 8 * i));
  }
  std::uint32_t crc = 0xFFFFFFFF;
  for (std::size_t i = 12; i < 29; ++i) {
    crc ^= static_cast<unsigned char>(bytes[i]);
    for (int k = 0; k < 8; ++k) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320U : 0U);
  }
  crc = ~crc;
  for (int i = 0; i < 4; ++i) bytes[static_cast<std::size_t>(29 + i)] = static_cast<char>(crc >> (24 - 8 * i));
  return bytes;
}

TEST(Png, SizesThatLieAreRefused) {
  const std::string bytes = encode({PNG_COLOR_TYPE_GRAY, 8}, 2, {"ab"});
  EXPECT_THAT(error_of([&] { decode_png(with_size(bytes, 100000, 100000), "m.png"); }),
              HasSubstr("100000 x 100000 cells"));
  EXPECT_THAT(error_of([&] { decode_png(with_size(bytes, 8000, 8000), "m.png"); }),
              HasSubstr("too short for the size"));
  EXPECT_NE(error_of([&] { decode_png(with_size(bytes, 2, 2), "m.png"); }), "");
  EXPECT_NE(error_of([&] { decode_png(with_size(bytes, 0, 2), "m.png"); }), "");
}

Image pgm(const std::string& content) { return decode_pgm(content, "m.pgm"); }
std::string pgm_error(const std::string& content) {
  return error_of([&] { pgm(content); });
}

TEST(Pgm, BinaryWithComments) {
  const Image image = pgm("P5\n# CREATOR: map_saver 0.05 m/pix\n2 1 # two\n255\n\xCD#");
  EXPECT_EQ(image.at(0, 0).red, 205 * 257);
  EXPECT_EQ(image.at(1, 0).red, '#' * 257);
  EXPECT_EQ(image.at(1, 0).alpha, 65535);
}

TEST(Pgm, TextWithComments) {
  const Image image = pgm("P2\n# c\n2 2\n# c\n10\n0 5\n# c\n10 1");
  EXPECT_EQ(image.at(1, 0).red, 32768);
  EXPECT_EQ(image.at(0, 1).red, 65535);
}

TEST(Pgm, SixteenBitsAreBigEndian) {
  const Image image = pgm(std::string("P5 2 1 65535\n\x12\x34\xFF\xFF"));
  EXPECT_EQ(image.at(0, 0).red, 0x1234);
  EXPECT_EQ(image.at(1, 0).red, 65535);
  EXPECT_EQ(pgm(std::string("P5 1 1 256\n\x01\x00", 13)).at(0, 0).red, 65535);
}

TEST(Pgm, TheFirstRowIsTheTop) {
  const Image image = pgm("P2 1 2 1 0 1");
  EXPECT_EQ(image.at(0, 0).red, 0);
  EXPECT_EQ(image.at(0, 1).red, 65535);
}

TEST(Pgm, UnsoundFilesAreRefused) {
  EXPECT_THAT(pgm_error("P5"), HasSubstr("ends early"));
  EXPECT_THAT(pgm_error("P5 x"), HasSubstr("the width is not a number"));
  EXPECT_THAT(pgm_error("P5 2 2 255"), HasSubstr("the header does not end"));
  EXPECT_THAT(pgm_error("P5 2 2 255\nabc"), HasSubstr("needs 4 bytes of pixels, the file has 3"));
  EXPECT_THAT(pgm_error("P5 2 2 255\nabcde"), HasSubstr("1 bytes follow the last pixel"));
  EXPECT_THAT(pgm_error("P5 2 2 256\nabcd"), HasSubstr("needs 8 bytes"));
  EXPECT_THAT(pgm_error("P5 1 1 100\n\xFF"), HasSubstr("a pixel is over 100"));
  EXPECT_THAT(pgm_error("P2 1 1 100\n101"), HasSubstr("a pixel is over 100"));
  EXPECT_THAT(pgm_error("P2 2 2 100\n1 2 3 "), HasSubstr("ends early"));
  EXPECT_THAT(pgm_error("P2 2 2 100\n1 2 -3 4"), HasSubstr("a pixel is not a number"));
  EXPECT_THAT(pgm_error("P2 1 1 100\n1 2"), HasSubstr("follow the last pixel"));
  EXPECT_THAT(pgm_error("P5 1 1 0\nx"), HasSubstr("the maximum is 0"));
  EXPECT_THAT(pgm_error("P5 1 1 65536\nx"), HasSubstr("the maximum is over 65535"));
  EXPECT_THAT(pgm_error("P5 0 1 255\n"), HasSubstr("0 x 1 cells"));
  EXPECT_THAT(pgm_error("P5 -1 1 255\n"), HasSubstr("the width is not a number"));
  EXPECT_THAT(pgm_error("P5 100000 100000 255\nx"), HasSubstr("100000 x 100000 cells"));
  EXPECT_THAT(pgm_error("P5 99999999999999999999 1 255\nx"), HasSubstr("the width is over"));
  EXPECT_THAT(pgm_error("P5 8000 8000 255\nx"), HasSubstr("needs 64000000 bytes"));
}

}  // namespace
}  // namespace krait::host::import_image_test
