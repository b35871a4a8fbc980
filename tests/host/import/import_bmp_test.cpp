// SPDX-License-Identifier: Apache-2.0
// Bitmaps of every kind that is read, written by hand, and spoiled ones.
#include <gmock/gmock.h>

#include "../scratch.hpp"
#include "bmp_writer.hpp"
#include "host/import/image.hpp"
#include "host/import/import.hpp"

namespace krait::host::import_bmp_test {
namespace {

using testing::HasSubstr;

Image decode(const std::string& content) { return decode_image(content, "m.bmp"); }
std::string error(const std::string& content) {
  return error_of([&] { decode(content); });
}

void expect_pixel(const Image& image, int column, int row, int red, int green, int blue) {
  const Pixel& p = image.at(column, row);
  EXPECT_EQ(p.red, 257 * red);
  EXPECT_EQ(p.green, 257 * green);
  EXPECT_EQ(p.blue, 257 * blue);
  EXPECT_EQ(p.alpha, 65535);
}

TEST(Bmp, RgbHasBlueFirstAndTheLowestRowFirst) {
  const Image image = decode(bmp({24, 2, 2, {}}, {"abcdef", "ghijkl"}));
  ASSERT_EQ(image.columns, 2);
  ASSERT_EQ(image.rows, 2);
  EXPECT_FALSE(image.has_alpha);
  EXPECT_FALSE(image.lossy);
  expect_pixel(image, 0, 1, 'c', 'b', 'a');
  expect_pixel(image, 1, 0, 'l', 'k', 'j');
}

TEST(Bmp, ANegativeHeightHasTheTopRowFirst) {
  const Image image = decode(bmp({32, 1, -2, {}}, {std::string("abc\0", 4), "efgh"}));
  ASSERT_EQ(image.rows, 2);
  expect_pixel(image, 0, 0, 'c', 'b', 'a');
  expect_pixel(image, 0, 1, 'g', 'f', 'e');
}

TEST(Bmp, PalettesOfOneFourAndEightBits) {
  const std::vector<std::uint32_t> colors = {0x000000, 0x0A1420, 0xFFFFFF};
  const Image one = decode(bmp({1, 10, 1, {0x000000, 0xFFFFFF}}, {"\x81\x40"}));
  for (int column = 0; column < 10; ++column) {
    const int grey = column == 0 || column == 7 || column == 9 ? 255 : 0;
    expect_pixel(one, column, 0, grey, grey, grey);
  }
  const Image four = decode(bmp({4, 3, 1, colors}, {"\x12\x00"}));
  expect_pixel(four, 0, 0, 10, 20, 32);
  expect_pixel(four, 1, 0, 255, 255, 255);
  expect_pixel(four, 2, 0, 0, 0, 0);
  expect_pixel(decode(bmp({8, 2, 1, colors}, {std::string("\0\1", 2)})), 1, 0, 10, 20, 32);
}

TEST(Bmp, APaletteWithoutACountIsWhole) {
  std::string whole = bmp({1, 2, 1, {0x000000, 0xFFFFFF}}, {"\x40"});
  whole[46] = 0;
  expect_pixel(decode(whole), 1, 0, 255, 255, 255);
}

TEST(Bmp, TruncatedAtAnyLengthIsRefused) {
  const std::string whole = bmp({8, 2, 2, {0x000000, 0xFFFFFF}}, {std::string("\0\1", 2), std::string("\1\0", 2)});
  EXPECT_EQ(error(whole), "");
  for (std::size_t length = 2; length < whole.size(); ++length) {
    EXPECT_THAT(error(whole.substr(0, length)), HasSubstr("m.bmp: is not a sound BMP: it needs")) << length;
  }
}

TEST(Bmp, HeadersThatLieAreRefused) {
  const auto changed = [](std::size_t offset, const std::string& bytes) {
    std::string content = bmp({24, 1, 1, {}}, {"abc"});
    return content.replace(offset, bytes.size(), bytes);
  };
  EXPECT_THAT(error(bmp({24, 100000, 100000, {}}, {"abc"})), HasSubstr("100000 x 100000 cells"));
  EXPECT_THAT(error(bmp({24, 8000, 8000, {}}, {"abc"})), HasSubstr("it needs 192000054 bytes, the file has 58"));
  EXPECT_THAT(error(bmp({24, 1, -0x7FFFFFFF - 1, {}}, {"abc"})), HasSubstr("1 x 2147483648 cells"));
  EXPECT_THAT(error(bmp({24, -1, 1, {}}, {"abc"})), HasSubstr("no width or no height"));
  EXPECT_THAT(error(bmp({24, 1, 0, {}}, {"abc"})), HasSubstr("no width or no height"));
  EXPECT_THAT(error(bmp({16, 1, 1, {}}, {"ab"})), HasSubstr("pixels of 16 bits; known are 1, 4, 8, 24 and 32"));
  EXPECT_THAT(error(bmp({1, 1, 1, {1, 2, 3}}, {"a"})), HasSubstr("a palette of 3 colours; at most 2"));
  EXPECT_THAT(error(bmp({8, 1, 1, {0, 1}}, {"\2"})), HasSubstr("a pixel has a colour that the palette has not"));
  EXPECT_THAT(error(changed(30, "\3")), HasSubstr("compressed or masked (kind 3); save it without compression"));
  EXPECT_THAT(error(changed(14, "\x0C")), HasSubstr("a header of 12 bytes; known are 40 to 124"));
  EXPECT_THAT(error(changed(10, "\x0E")), HasSubstr("its pixels begin before its header's end"));
  EXPECT_THAT(error(changed(10, "\xFF\xFF\xFF\xFF")), HasSubstr("it needs 4294967299 bytes"));
}

TEST(Bmp, AFlippedBitIsRefusedOrHarmless) {
  const std::string whole = bmp({4, 3, 2, {0x000000, 0x102030, 0xFFFFFF}}, {"\x12\x10", "\x21\x20"});
  for (std::size_t i = 0; i < 8 * whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i / 8] = static_cast<char>(damaged[i / 8] ^ (1 << (i % 8)));
    error(damaged);  // no crash, no other exception
  }
}

class BmpMapTest : public ScratchTest {};

TEST_F(BmpMapTest, IsAMapsImage) {
  write("m.bmp", bmp({1, 2, 2, {0x000000, 0xFFFFFF}}, {"\x40", "\xC0"}));
  const Workspace w = import_workspace(write("m.yaml",
                                             "image: m.bmp\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n"
                                             "occupied_thresh: 0.65\nfree_thresh: 0.196\n"),
                                       {});
  EXPECT_THAT(w.cells->occupied, testing::ElementsAre(1, 0, 0, 0));
  EXPECT_THAT(w.warnings, testing::IsEmpty());
}

}  // namespace
}  // namespace krait::host::import_bmp_test
