// SPDX-License-Identifier: Apache-2.0
#include "firmware/request.hpp"

#include <cstring>
#include <limits>

#include "krait/robot/chain.hpp"

namespace krait::firmware {
namespace {

constexpr int kDefaultTrailers = 15;

bool same(const char* a, const char* b) { return std::strcmp(a, b) == 0; }

// The decimal number at the beginning of `text`, which is moved behind it. False without digits or beyond 64 bits.
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

bool parse_number(const char* text, std::uint64_t& number) { return take_number(text, number) && *text == '\0'; }

bool parse_bytes(const char* text, std::uint64_t& bytes) {
  if (!take_number(text, bytes)) return false;
  const unsigned shift = *text == 'K' ? 10 : *text == 'M' ? 20 : 0;
  if (bytes > (std::numeric_limits<std::uint64_t>::max() >> shift)) return false;
  bytes <<= shift;
  return text[shift == 0 ? 0 : 1] == '\0';
}

const char* parse_robot(const char* text, const char* model, bool has_trailers, Request& request) {
  const std::size_t length = std::strlen(model);
  if (std::strncmp(text, model, length) != 0) return "--robot: this firmware plans for another model";
  request.robot = text;
  const char* rest = text + length;
  if (!has_trailers) return *rest == '\0' ? nullptr : "--robot: this model has no trailers";
  std::uint64_t trailers = 0;
  if (*rest != ':' || !parse_number(rest + 1, trailers) || trailers > kMaxTrailers) {
    return "--robot: give the number of trailers, 0 to 25, as in snake:5";
  }
  request.trailers = static_cast<int>(trailers);
  return nullptr;
}

const char* parse_option(const char* option, const char* value, const char* model, bool has_trailers,
                         Request& request) {
  if (same(option, "--robot")) return parse_robot(value, model, has_trailers, request);
  if (same(option, "--seed")) return parse_number(value, request.seed) ? nullptr : "--seed: give a whole number";
  if (same(option, "--memory")) {
    const bool good = parse_bytes(value, request.memory) && request.memory > 0;
    return good ? nullptr : "--memory: give bytes above 0, as 131072, 128K or 1M";
  }
  if (same(option, "--iterations")) {
    return parse_number(value, request.iterations) ? nullptr : "--iterations: give a whole number";
  }
  return "unknown option: --robot, --seed, --memory, --iterations and --icount are known";
}

}  // namespace

const char* parse(int count, const char* const* words, const char* model, bool has_trailers, Request& request) {
  request = {};
  request.robot = model;
  request.trailers = has_trailers ? kDefaultTrailers : 0;
  for (int i = 0; i < count; ++i) {
    if (same(words[i], "--icount")) {
      request.clock_counts_instructions = true;
      continue;
    }
    if (i + 1 == count) return "an option lacks its value";
    const char* wrong = parse_option(words[i], words[i + 1], model, has_trailers, request);
    if (wrong != nullptr) return wrong;
    ++i;
  }
  return nullptr;
}

}  // namespace krait::firmware
