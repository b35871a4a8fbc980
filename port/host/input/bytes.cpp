// SPDX-License-Identifier: Apache-2.0
#include "host/input/bytes.hpp"

#include <charconv>
#include <string_view>

#include "host/workspace/workspace.hpp"

namespace krait::host {

constexpr std::uint64_t kMostMemory = std::uint64_t{64} << 30U;

std::uint64_t parse_bytes(const std::string& option, const std::string& text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  unsigned shift = 64;
  if (unit.empty()) shift = 0;
  if (unit == "K") shift = 10;
  if (unit == "M") shift = 20;
  if (unit == "G") shift = 30;
  if (error != std::errc() || shift == 64 || value > (kMostMemory >> shift)) {
    throw InputError(option + " " + text + ": give bytes, as 131072, 128K, 64M or 1G, at most 64G");
  }
  return value << shift;
}

}  // namespace krait::host
