// SPDX-License-Identifier: Apache-2.0
// Parses JSON within bounds, and reads its fields so that every error names the file and the field. Who looks into a
// Json includes nlohmann/json.hpp, which takes a compiler a second to read: most only hand it on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/workspace/workspace.hpp"

namespace krait::host {

using Json = nlohmann::ordered_json;

inline constexpr int kMaxDepth = 64;               // of nested lists and objects
inline constexpr std::size_t kMaxKeys = 1000;      // of an object, which is searched from its first to its last
inline constexpr double kMaxCoordinate = 1e7;      // metres, world coordinates
inline constexpr double kLeastGoalRadius = 0.001;  // metres, of options: a smaller one is most likely a slip
inline constexpr double kMaxFarCoordinate = 1e10;  // metres, in the file of a map, which is then brought near
inline constexpr double kMaxAngle = 1000;          // radians
inline constexpr std::size_t kMaxNameBytes = 200;

// Throws InputError where a text in a language, "JSON", has zero bytes: a parser may take the first for its end.
void require_no_zero_bytes(const std::string& text, const std::string& language, const std::string& file);

// Throws InputError: zero bytes, a syntax error with its position, nesting beyond kMaxDepth, more than kMaxKeys keys in
// an object, a key given twice.
Json parse_json(const std::string& text, const std::string& file);

// A value of a parsed document and the place where it stands. The document must outlive it.
// Every reader throws InputError "FILE: PLACE: must be …, is …".
class Field {
 public:
  Field(const Json& document, const std::string& file);

  const Json& value() const { return *value_; }
  const std::string& place() const { return place_; }  // "obstacles[3].circle"; empty for the document itself

  void keys(std::initializer_list<const char*> known) const;  // an object that has no other keys
  void require(
      std::initializer_list<const char*> keys) const;  // an object that has all of these, or says which it lacks
  bool has(const char* key) const;
  Field at(const char* key) const;                                             // the member of an object
  std::size_t size(std::size_t least = 0, std::size_t most = SIZE_MAX) const;  // of a list, from least to most
  Field item(std::size_t index) const;                                         // of a list

  // Finite; the unit is that of the bounds, for whoever reads the refusal.
  double number(double least, double most, const std::string& unit = {}) const;
  long long integer(long long least, long long most, const std::string& of = {}) const;  // of what, as "trailers"
  bool boolean() const;
  std::string text() const;
  std::string printed() const;                      // a text that is_safe_to_print
  std::string name() const;                         // 1 to kMaxNameBytes bytes that are safe to print
  Point point(double most = kMaxCoordinate) const;  // [x, y] in metres, both from -most to most
  Ring ring(std::size_t most = SIZE_MAX, double most_coordinate = kMaxCoordinate) const;  // at least 3 points

  std::string shown_value() const;  // for messages: short, on one line; of a list or an object how many it holds
  [[noreturn]] void fail(const std::string& what) const;

 private:
  Field(const Json& value, std::shared_ptr<const std::string> file, std::string place);
  [[noreturn]] void fail_expecting(const std::string& expected) const;

  const Json* value_;
  std::shared_ptr<const std::string> file_;
  std::string place_;
};

Json to_json(const Ring& ring);  // [[x, y], …]

// That an object or map has more than kMaxKeys.
[[noreturn]] void fail_keys(const std::string& file);

// Whether one typing error makes the other word of a word: a letter more, less or wrong, or two that changed places.
bool is_misspelt(const std::string& a, const std::string& b);

// The text as a name may stand: escaped (safe_to_print), then cut to kMaxNameBytes between two characters.
std::string cleaned_name(const std::string& text);

// With at most 8 digits, for messages.
std::string shown(double number);

}  // namespace krait::host
