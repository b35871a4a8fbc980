// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

#include "../../whole_number.hpp"

namespace krait::host::test {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::exit(2);
}

std::uint64_t query_number(const char* text, std::uint64_t queries) {
  const std::uint64_t number = number_or_exit(text, 0, "--query");
  if (number >= queries) refuse("--query: a scene has the queries 0 to " + std::to_string(queries - 1));
  return number;
}

}  // namespace

std::uint64_t number_or_exit(const char* text, std::uint64_t least, const char* what) {
  const std::optional<std::uint64_t> number = krait::test::whole_number(text);
  if (!number || *number < least) {
    refuse(std::string(what) + ": '" + text + "' is no whole number from " + std::to_string(least) + " on");
  }
  return *number;
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
      options.first_scene = number_or_exit(argv[++i], 0, "--from");
    } else if (query) {
      options.query = query_number(argv[++i], queries);
    } else {
      options.plans = number_or_exit(argv[i], 1, "the number of plans");
    }
  }
  return options;
}

}  // namespace krait::host::test
