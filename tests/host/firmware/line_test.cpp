// SPDX-License-Identifier: Apache-2.0
// What firmware prints, against the C library and a JSON parser.
#include "firmware/line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace krait::firmware {
namespace {

TEST(FirmwareLine, ADecimalIsTheNumberToAMillionth) {
  for (const float number : {0.0F, 1.5F, 0.9999999F, std::nextafter(1.0F, 0.0F), 12.000001F, 0.0999999F, 3.9e9F}) {
    Line line;
    const std::string text = line.put_decimal(number).end();
    ASSERT_EQ(text.size() - text.find('.'), std::string(".123456\n").size()) << text;
    EXPECT_NEAR(std::strtod(text.c_str(), nullptr), static_cast<double>(number), 1e-6) << text;
  }
}

TEST(FirmwareLine, MetresAreToAMillimetreAndHaveASign) {
  for (const double number : {0.0, -0.0004, -0.0006, 1.5, -12.9996, 999'999'999.9994, -3.9e9, 0.0005}) {
    char expected[32];
    std::snprintf(expected, sizeof expected, "%.3f", std::abs(number) < 5e-4 ? 0.0 : number);
    Line line;
    const std::string text = line.put_metres(number).end();
    EXPECT_NEAR(std::strtod(text.c_str(), nullptr), number, 5.01e-4) << text;
    EXPECT_EQ(text.size(), std::string(expected).size() + 1) << text;
  }
  JsonLine line;
  EXPECT_EQ(nlohmann::json::parse(line.add_metres("x", -1.25).end()).at("x"), -1.25);
}

TEST(FirmwareLine, WhatDoesNotFitIsCutOff) {
  Line line;
  for (int i = 0; i < 2000; ++i) line.put("ab");
  const std::string text = line.end();
  EXPECT_LT(text.size(), 2000U);
  EXPECT_EQ(text, std::string(line.end()));
  EXPECT_EQ(text.back(), '\n');
}

TEST(FirmwareLine, OfJsonIsJsonWhateverTheNames) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  JsonLine line;
  line.add("a \"b\"\\", "c\nd\x1F\xC3\xA9").add("none", std::uint64_t{0}).add("most", kMost);
  line.add_hash("hash", 0xFEDC'BA98'7654'3210U).add_seconds("time", 1'000'000'001).add_null("unknown");
  const nlohmann::json json = nlohmann::json::parse(line.end());
  EXPECT_EQ(json.at("a  b  "), "c d \xC3\xA9");
  EXPECT_EQ(json.at("none"), 0);
  EXPECT_EQ(json.at("most"), kMost);
  EXPECT_EQ(json.at("hash"), "fedcba9876543210");
  EXPECT_EQ(json.at("time"), 1.000000001);
  EXPECT_TRUE(json.at("unknown").is_null());
}

}  // namespace
}  // namespace krait::firmware
