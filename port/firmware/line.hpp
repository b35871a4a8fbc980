// SPDX-License-Identifier: Apache-2.0
// Text put together without the C library's formatting.
#pragma once

#include <cstddef>
#include <cstdint>

namespace krait::firmware {

// One line. What does not fit is cut off.
class Line {
 public:
  Line& put(char c);
  Line& put(const char* text);
  Line& put(std::uint64_t number, int least_digits = 1);  // decimal
  Line& put_decimal(float number);                        // 0 <= number < 4e9, to 6 decimals
  Line& put_metres(double metres);                        // |metres| < 4e9, to a millimetre

  bool empty() const { return length_ == 0; }
  // With a line feed. Valid until the line changes.
  const char* end();

 private:
  static constexpr std::size_t kRoom = 1536;
  char text_[kRoom + 2];  // and line feed, NUL
  std::size_t length_ = 0;
};

// A line that is one JSON object.
class JsonLine {
 public:
  JsonLine& add(const char* name, const char* text);
  JsonLine& add(const char* name, std::uint64_t number);
  JsonLine& add_hash(const char* name, std::uint64_t hash);  // 16 hexadecimal digits, as text
  JsonLine& add_seconds(const char* name, std::uint64_t nanoseconds);
  JsonLine& add_decimal(const char* name, float number);  // as Line::put_decimal
  JsonLine& add_metres(const char* name, double metres);  // as Line::put_metres
  JsonLine& add_null(const char* name);

  // Closes the object.
  const char* end() { return line_.put('}').end(); }

 private:
  void put_name(const char* name);
  void put_quoted(const char* text);

  Line line_;
};

}  // namespace krait::firmware
