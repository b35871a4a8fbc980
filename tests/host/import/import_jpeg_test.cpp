// SPDX-License-Identifier: Apache-2.0
// JPEGs of every kind that TurboJPEG writes, and spoiled ones.
#include <gmock/gmock.h>

#include "../scratch.hpp"
#include "host/import/image.hpp"
#include "host/import/import.hpp"
#include "jpeg_writer.hpp"

namespace krait::host::import_jpeg_test {
namespace {

using testing::HasSubstr;

Image decode(const std::string& content) { return decode_image(content, "m.jpg"); }
std::string error(const std::string& content) {
  return error_of([&] { decode(content); });
}

std::string repeated(const std::string& one, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += one;
  return all;
}

// Two blocks of 8 x 8, black and white.
std::string halves(int subsampling = TJSAMP_GRAY, int flags = 0) {
  const std::string row = repeated(std::string("\0\0\0", 3), 8) + repeated("\xFF\xFF\xFF", 8);
  return jpeg(16, 8, subsampling, 100, repeated(row, 8), flags);
}

TEST(Jpeg, BlocksOfOneGreyAreExact) {
  for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
    const Image image = decode(halves(TJSAMP_GRAY, flags));
    ASSERT_EQ(image.columns, 16);
    ASSERT_EQ(image.rows, 8);
    EXPECT_TRUE(image.lossy);
    EXPECT_FALSE(image.has_alpha);
    for (int row = 0; row < 8; ++row) {
      EXPECT_EQ(image.at(7, row).red, 0);
      EXPECT_EQ(image.at(8, row).blue, 65535);
      EXPECT_EQ(image.at(8, row).alpha, 65535);
    }
  }
}

TEST(Jpeg, ColoursKeepTheirOrder) {
  const Image image = decode(jpeg(8, 8, TJSAMP_444, 100, repeated("\xC8\x64\x32", 64)));
  EXPECT_NEAR(image.at(3, 3).red / 257, 200, 2);
  EXPECT_NEAR(image.at(3, 3).green / 257, 100, 2);
  EXPECT_NEAR(image.at(3, 3).blue / 257, 50, 2);
}

TEST(Jpeg, InCmykIsNamed) {
  EXPECT_EQ(error(jpeg(8, 8, TJSAMP_444, 100, repeated("\xC8\x64\x32\x10", 64), 0, TJPF_CMYK)),
            "m.jpg: is a JPEG in CMYK: save it in grey or RGB");
}

TEST(Jpeg, TruncatedAtAnyLengthIsRefused) {
  const std::string whole = halves();
  for (std::size_t length = 3; length + 2 < whole.size(); ++length) {
    EXPECT_THAT(error(whole.substr(0, length)), HasSubstr("m.jpg: is not a sound JPEG: ")) << length;
  }
}

TEST(Jpeg, SizesThatLieAreRefused) {
  const auto with_size = [](const std::string& size) {
    return halves().replace(halves().find("\xFF\xC0") + 5, 4, size);
  };
  EXPECT_THAT(error(with_size("\xFD\xE8\xFD\xE8")), HasSubstr("65000 x 65000 cells"));
  EXPECT_THAT(error(with_size("\x1F\x40\x1F\x40")), HasSubstr("too short for the size that its header says"));
  EXPECT_NE(error(with_size(std::string("\0\0\0\1", 4))), "");
}

TEST(Jpeg, AFlippedBitIsRefusedOrHarmless) {
  const std::string whole = halves(TJSAMP_420);
  for (std::size_t i = 0; i < 8 * whole.size(); i += 3) {
    std::string damaged = whole;
    damaged[i / 8] = static_cast<char>(damaged[i / 8] ^ (1 << (i % 8)));
    error(damaged);  // no crash, no other exception
  }
}

class JpegMapTest : public ScratchTest {};

TEST_F(JpegMapTest, IsAMapsImageAndSaysThatItIsBlurred) {
  write("m.jpg", halves());
  const Workspace w = import_workspace(write("m.yaml",
                                             "image: m.jpg\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n"
                                             "occupied_thresh: 0.65\nfree_thresh: 0.196\n"),
                                       {});
  EXPECT_TRUE(w.cells->at(7, 0));
  EXPECT_FALSE(w.cells->at(8, 0));
  EXPECT_THAT(w.warnings, testing::ElementsAre(path("m.jpg") + ": is a JPEG, whose compression blurs cells along "
                                                               "walls; a PNG keeps them"));
}

}  // namespace
}  // namespace krait::host::import_jpeg_test
