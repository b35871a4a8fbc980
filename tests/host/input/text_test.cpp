// SPDX-License-Identifier: Apache-2.0
// What may be shown to a person as it is, and how the rest is escaped.
#include "host/workspace/text.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace krait::host {
namespace {

// UTF-8 by its definition.
std::string utf8(std::uint32_t code) {
  const auto tail = [code](unsigned shift) { return static_cast<char>(0x80U + ((code >> shift) & 0x3FU)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0U + (code >> 6U)), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0U + (code >> 12U)), tail(6), tail(0)};
  return {static_cast<char>(0xF0U + (code >> 18U)), tail(12), tail(6), tail(0)};
}

bool is_meant_to_be_escaped(std::uint32_t code) {
  return code <= 0x1F || (code >= 0x7F && code <= 0x9F) || code == 0x61C || code == 0x200E || code == 0x200F ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

TEST(Text, EveryCharacterStaysOrIsEscapedByItsNumber) {
  for (std::uint32_t code = 0; code <= 0x10FFFF; ++code) {
    if (code >= 0xD800 && code <= 0xDFFF) continue;
    const std::string text = std::string("a").append(utf8(code)).append("b");
    const bool safe = !is_meant_to_be_escaped(code);
    ASSERT_EQ(is_safe_to_print(text), safe) << code;
    char number[16];
    std::snprintf(number, sizeof number, "\\u%04X", code);
    ASSERT_EQ(safe_to_print(text), safe ? text : std::string("a").append(number).append("b")) << code;
  }
}

TEST(Text, BytesThatAreNoUtf8AreEscapedOneByOne) {
  for (const auto& [bytes, escaped] : {std::pair<std::string, std::string>{"\x80", "\\x80"},
                                       {"a\xFFz", "a\\xFFz"},
                                       {"\xC3", "\\xC3"},
                                       {"\xC0\xAF", "\\xC0\\xAF"},
                                       {"\xE0\x82\x80", "\\xE0\\x82\\x80"},
                                       {"\xED\xA0\x80", "\\xED\\xA0\\x80"},
                                       {"\xF4\x90\x80\x80", "\\xF4\\x90\\x80\\x80"},
                                       {"\xE2\x82z", "\\xE2\\x82z"},
                                       {"\xF0\x9F\x90", "\\xF0\\x9F\\x90"}}) {
    EXPECT_FALSE(is_safe_to_print(bytes)) << escaped;
    EXPECT_EQ(safe_to_print(bytes), escaped);
  }
}

TEST(Text, WhatIsEscapedIsSafeAndStays) {
  const std::string once = safe_to_print(
      "a\x1B[31m\xFF\n\xE2\x80\xAE"
      "b\\");
  EXPECT_EQ(once, "a\\u001B[31m\\xFF\\u000A\\u202Eb\\");
  EXPECT_TRUE(is_safe_to_print(once));
  EXPECT_EQ(safe_to_print(once), once);
  EXPECT_TRUE(is_safe_to_print(""));
}

}  // namespace
}  // namespace krait::host
