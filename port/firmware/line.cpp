// SPDX-License-Identifier: Apache-2.0
#include "firmware/line.hpp"

namespace krait::firmware {

Line& Line::put(char c) {
  if (length_ < kRoom) text_[length_++] = c;
  return *this;
}

Line& Line::put(const char* text) {
  for (; *text != '\0'; ++text) put(*text);
  return *this;
}

Line& Line::put(std::uint64_t number, int least_digits) {
  char digits[20];
  int count = 0;
  while (number > 0 || count < least_digits) {
    digits[count++] = static_cast<char>('0' + number % 10);
    number /= 10;
  }
  while (count > 0) put(digits[--count]);
  return *this;
}

Line& Line::put_decimal(float number) {
  constexpr std::uint32_t kMillion = 1'000'000;
  auto whole = static_cast<std::uint32_t>(number);
  auto millionths = static_cast<std::uint32_t>((number - static_cast<float>(whole)) * 1e6F + 0.5F);
  if (millionths == kMillion) {
    ++whole;
    millionths = 0;
  }
  return put(std::uint64_t{whole}).put('.').put(std::uint64_t{millionths}, 6);
}

Line& Line::put_metres(double metres) {
  constexpr std::uint64_t kMillimetres = 1000;  // of a metre
  const bool negative = metres < 0.0;
  const auto millimetres = static_cast<std::uint64_t>((negative ? -metres : metres) * 1e3 + 0.5);
  if (negative && millimetres > 0) put('-');
  return put(millimetres / kMillimetres).put('.').put(millimetres % kMillimetres, 3);
}

const char* Line::end() {
  text_[length_] = '\n';
  text_[length_ + 1] = '\0';
  return text_;
}

// Control characters, quotes and backslashes, which no name of krait has, become spaces.
void JsonLine::put_quoted(const char* text) {
  line_.put('"');
  for (; *text != '\0'; ++text) {
    const bool plain = static_cast<unsigned char>(*text) >= ' ' && *text != '"' && *text != '\\';
    line_.put(plain ? *text : ' ');
  }
  line_.put('"');
}

void JsonLine::put_name(const char* name) {
  line_.put(line_.empty() ? '{' : ',');
  put_quoted(name);
  line_.put(':');
}

JsonLine& JsonLine::add(const char* name, const char* text) {
  put_name(name);
  put_quoted(text);
  return *this;
}

JsonLine& JsonLine::add(const char* name, std::uint64_t number) {
  put_name(name);
  line_.put(number);
  return *this;
}

JsonLine& JsonLine::add_hash(const char* name, std::uint64_t hash) {
  put_name(name);
  line_.put('"');
  for (unsigned shift = 64; shift > 0; shift -= 4) line_.put("0123456789abcdef"[(hash >> (shift - 4)) & 15U]);
  line_.put('"');
  return *this;
}

JsonLine& JsonLine::add_seconds(const char* name, std::uint64_t nanoseconds) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  put_name(name);
  line_.put(nanoseconds / kSecond).put('.').put(nanoseconds % kSecond, 9);
  return *this;
}

JsonLine& JsonLine::add_decimal(const char* name, float number) {
  put_name(name);
  line_.put_decimal(number);
  return *this;
}

JsonLine& JsonLine::add_metres(const char* name, double metres) {
  put_name(name);
  line_.put_metres(metres);
  return *this;
}

JsonLine& JsonLine::add_null(const char* name) {
  put_name(name);
  line_.put("null");
  return *this;
}

}  // namespace krait::firmware
