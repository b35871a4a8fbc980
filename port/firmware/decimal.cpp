// SPDX-License-Identifier: Apache-2.0
#include "firmware/decimal.hpp"

#include <limits>

namespace krait::firmware {

bool take_number(const char*& text, std::uint64_t& number) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  const char* const begin = text;
  number = 0;
  for (; *text >= '0' && *text <= '9'; ++text) {
    const auto digit = static_cast<std::uint64_t>(*text - '0');
    if (number > (kMost - digit) / 10) return false;
    number = number * 10 + digit;
  }
  return text != begin;
}

bool take_decimal(const char*& text, double& number) {
  constexpr int kMostDigits = 15;  // so that digits and power of ten are doubles, and their quotient is rounded once
  const bool negative = *text == '-';
  if (negative) ++text;
  std::uint64_t digits = 0;
  std::uint64_t scale = 1;
  int count = 0;
  bool point = false;
  for (; (*text >= '0' && *text <= '9') || (*text == '.' && !point); ++text) {
    if (*text == '.') {
      point = true;
      continue;
    }
    if (++count > kMostDigits) return false;
    digits = digits * 10 + static_cast<std::uint64_t>(*text - '0');
    if (point) scale *= 10;
  }
  const double size = static_cast<double>(digits) / static_cast<double>(scale);
  number = negative ? -size : size;
  return count > 0;
}

}  // namespace krait::firmware
