// SPDX-License-Identifier: Apache-2.0
// A constant of the library, as a build for measurements has it: the environment may vary one.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string_view>
#include <type_traits>

namespace krait::bench {

// `value`, times KRAIT_FACTOR where KRAIT_CONSTANT is this one's name.
template <class Number>
Number varied(const char* name, Number value) {
  const char* const wanted = std::getenv("KRAIT_CONSTANT");
  const char* const factor = std::getenv("KRAIT_FACTOR");
  if (wanted == nullptr || factor == nullptr || std::string_view(wanted) != name) return value;
  const double changed = static_cast<double>(value) * std::atof(factor);
  return static_cast<Number>(std::is_integral_v<Number> ? std::round(changed) : changed);
}

}  // namespace krait::bench
