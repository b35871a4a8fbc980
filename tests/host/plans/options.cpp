// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.hpp"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <system_error>

namespace krait::host::test {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::exit(2);
}

std::uint64_t query_number(const char* text, std::uint64_t queries) {
  const std::uint64_t number = whole_number(text, 0, "--query");
  if (number >= queries) refuse("--query: a scene has the queries 0 to " + std::to_string(queries - 1));
  return number;
}

}  // namespace

std::uint64_t whole_number(const char* text, std::uint64_t least, const char* what) {
  const std::string given = text;
  std::uint64_t number = 0;
  const char* end = given.data() + given.size();
  const auto [stopped, error] = std::from_chars(given.data(), end, number);
  if (error != std::errc() || stopped != end || number < least) {
    refuse(std::string(what) + ": '" + given + "' is no whole number from " + std::to_string(least) + " on");
  }
  return number;
}

std::uint64_t default_plans(std::uint64_t few, std::uint64_t many) {
  const char* asked = std::getenv("KRAIT_LONG_TESTS");
  return asked != nullptr && std::string(asked) == "1" ? many : few;
}

Options read_options(int argc, char** argv, std::uint64_t plans, std::uint64_t queries) {
  Options options;
  options.plans = plans;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool from = argument == "--from";
    const bool query = argument == "--query" && queries > 0;
    if ((from || query) && i + 1 == argc) refuse(argument + ": the number is missing");
    if (from) {
      options.first_scene = whole_number(argv[++i], 0, "--from");
    } else if (query) {
      options.query = query_number(argv[++i], queries);
    } else {
      options.plans = whole_number(argv[i], 1, "the number of plans");
    }
  }
  return options;
}

}  // namespace krait::host::test
