// SPDX-License-Identifier: Apache-2.0
#include "host/workspace/text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

struct Range {
  std::uint32_t first;
  std::uint32_t last;
};

constexpr std::array<Range, 6> kUnsafe = {
    {{0, 0x1F}, {0x7F, 0x9F}, {0x61C, 0x61C}, {0x200E, 0x200F}, {0x2028, 0x202E}, {0x2066, 0x2069}}};

bool is_unsafe(std::uint32_t code) {
  return std::any_of(kUnsafe.begin(), kUnsafe.end(),
                     [code](const Range& range) { return range.first <= code && code <= range.last; });
}

struct Character {
  std::size_t bytes = 1;
  std::uint32_t code = 0;
  bool valid = false;  // otherwise one byte that is no UTF-8
};

// The first character of a text that is not empty.
Character first_of(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {1, lead, true};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || bytes > text.size()) return {};
  std::uint32_t code = lead & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return {};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kLeast[bytes] || code > 0x10FFFF || surrogate) return {};
  return {bytes, code, true};
}

}  // namespace

bool is_safe_to_print(std::string_view text) {
  while (!text.empty()) {
    const Character character = first_of(text);
    if (!character.valid || is_unsafe(character.code)) return false;
    text.remove_prefix(character.bytes);
  }
  return true;
}

std::string safe_to_print(std::string_view text) {
  std::string safe;
  while (!text.empty()) {
    const Character character = first_of(text);
    if (!character.valid) {
      safe += printed("\\x%02X", static_cast<std::uint8_t>(text.front()));
    } else if (is_unsafe(character.code)) {
      safe += printed("\\u%04X", character.code);
    } else {
      safe += text.substr(0, character.bytes);
    }
    text.remove_prefix(character.bytes);
  }
  return safe;
}

}  // namespace krait::host
