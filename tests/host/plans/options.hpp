// SPDX-License-Identifier: GPL-3.0-or-later
// What a program of random plans is asked for: [--from SEED] [--query Q] [N].
#pragma once

#include <cstdint>
#include <optional>

namespace krait::host::test {

struct Options {
  std::uint64_t plans = 0;             // to be judged
  std::uint64_t first_scene = 1;       // its seed
  std::optional<std::uint64_t> query;  // of the first scene, alone
};

// A whole number of at least `least` in decimal digits. Exits with 2 after one line on stderr for any other text;
// `what` names the argument there.
std::uint64_t whole_number(const char* text, std::uint64_t least, const char* what);

// The number of plans that is judged unless another is asked for: `many` where KRAIT_LONG_TESTS is 1, else `few`.
std::uint64_t default_plans(std::uint64_t few, std::uint64_t many);

// `queries` is the number of queries of a scene, 0 where the program does not plan one alone. Exits as whole_number.
Options read_options(int argc, char** argv, std::uint64_t plans, std::uint64_t queries);

}  // namespace krait::host::test
