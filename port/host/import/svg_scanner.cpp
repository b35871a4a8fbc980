// SPDX-License-Identifier: Apache-2.0
#include "host/import/svg_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "host/input/json.hpp"

namespace krait::host {
namespace {

constexpr double kMost = 1e15;
constexpr std::string_view kSeparators = " \t\r\n\f,";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::size_t letters(std::string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_letter) - text.begin());
}

}  // namespace

void SvgScanner::skip_separators() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kSeparators), rest_.size()));
}

std::string SvgScanner::next_text() const {
  if (rest_.empty()) return "the end";
  std::string text = cleaned_name(std::string(rest_.substr(0, 20)));
  return text.insert(0, 1, '"').append(1, '"');
}

void SvgScanner::fail(const std::string& what) const {
  fail_(what);
  throw std::logic_error("an error that was not reported");
}

bool SvgScanner::done() {
  skip_separators();
  return rest_.empty();
}

bool SvgScanner::at_number() {
  skip_separators();
  return !rest_.empty() && !is_letter(rest_.front()) && rest_.front() != ')';
}

double SvgScanner::number() {
  skip_separators();
  std::string_view text = rest_;
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !(std::abs(value) <= kMost)) fail("a number must stand here, not " + next_text());
  rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
  return value;
}

bool SvgScanner::flag() {
  skip_separators();
  if (!rest_.starts_with('0') && !rest_.starts_with('1')) fail("a flag, 0 or 1, must stand here, not " + next_text());
  const bool set = rest_.front() == '1';
  rest_.remove_prefix(1);
  return set;
}

char SvgScanner::letter() {
  skip_separators();
  if (rest_.empty() || !is_letter(rest_.front())) fail("a command must stand here, not " + next_text());
  const char c = rest_.front();
  rest_.remove_prefix(1);
  return c;
}

std::string_view SvgScanner::word() {
  skip_separators();
  const std::string_view word = rest_.substr(0, letters(rest_));
  rest_.remove_prefix(word.size());
  return word;
}

std::string_view SvgScanner::unit() {
  const std::string_view unit = rest_.substr(0, rest_.starts_with('%') ? 1 : letters(rest_));
  rest_.remove_prefix(unit.size());
  return unit;
}

void SvgScanner::expect(char c) {
  skip_separators();
  if (!rest_.starts_with(c)) fail(std::string("'") + c + "' must stand here, not " + next_text());
  rest_.remove_prefix(1);
}

}  // namespace krait::host
