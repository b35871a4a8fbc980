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
std::uint64_t number_or_exit(const char* text, std::uint64_t least, const char* what);

// `plans` is the number of plans unless another is asked for, `queries` the number of queries of a scene, 0 where the
// program does not plan one alone. Exits as number_or_exit.
Options read_options(int argc, char** argv, std::uint64_t plans, std::uint64_t queries);

}  // namespace krait::host::test
