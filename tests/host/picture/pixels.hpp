// SPDX-License-Identifier: Apache-2.0
// The pixels of a drawn PNG, read back with another library.
#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

#include "host/picture/colors.hpp"
#include "host/picture/figure.hpp"

namespace krait::host {

struct Pixels {
  unsigned width = 0;
  unsigned height = 0;
  std::vector<std::uint8_t> rgb;

  Color at(Point sheet) const {
    const auto column = static_cast<std::size_t>(sheet.x * kPixelsPerPoint);
    const auto row = static_cast<std::size_t>(sheet.y * kPixelsPerPoint);
    const std::size_t i = 3 * (row * width + column);
    return {rgb.at(i), rgb.at(i + 1), rgb.at(i + 2)};
  }
};

inline Pixels decode(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&image, png.data(), png.size())) << image.message;
  image.format = PNG_FORMAT_RGB;
  Pixels pixels{image.width, image.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, pixels.rgb.data(), 0, nullptr)) << image.message;
  return pixels;
}

}  // namespace krait::host
