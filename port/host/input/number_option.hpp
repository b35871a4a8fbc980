// SPDX-License-Identifier: Apache-2.0
// Options of a program that take a number.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/input/json.hpp"

namespace krait::host {

// A finite number and nothing else.
inline std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// As many numbers as there are bounds, with commas between, each from minus to plus its bound; nothing if the text has
// another form.
inline std::optional<std::vector<double>> parse_numbers(std::string_view text, const std::vector<double>& bounds) {
  std::vector<double> values;
  for (const double bound : bounds) {
    const bool last = values.size() + 1 == bounds.size();
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != last) return std::nullopt;
    const std::optional<double> value = parse_number(text.substr(0, comma));
    if (!value || std::abs(*value) > bound) return std::nullopt;
    values.push_back(*value);
    if (!last) text.remove_prefix(comma + 1);
  }
  return values;
}

// Of an X,Y,… that is refused: "; a map beyond 1e7 m is moved to around 0: krait compile MAP says by how much" where it
// is for being so far, else nothing.
inline std::string hint_of_far_place(std::string_view text) {
  const std::optional<std::vector<double>> place = parse_numbers(text, std::vector<double>(3, HUGE_VAL));
  if (!place || !(std::max(std::abs((*place)[0]), std::abs((*place)[1])) > kMaxCoordinate)) return "";
  return "; a map beyond 1e7 m is moved to around 0: krait compile MAP says by how much";
}

// Lets an option take finite numbers from `least` to `most` only; the refusal names the unit.
inline CLI::Validator number_in(double least, double most, const std::string& unit) {
  const auto check = [least, most, unit](const std::string& text) -> std::string {
    const std::optional<double> value = parse_number(text);
    if (value && *value >= least && *value <= most) return {};
    return "give " + unit + " from " + shown(least) + " to " + shown(most) + ", not " + text;
  };
  return {check, "", "number"};
}

}  // namespace krait::host
