// SPDX-License-Identifier: Apache-2.0
// What the firmware is asked for, from the words of a command line.
#pragma once

#include <cstdint>

namespace krait::firmware {

struct Request {
  const char* robot = "";                  // "snake:15", "truck:2", "car", …
  int trailers = 0;                        // the number after the colon
  std::uint64_t seed = 1;                  //
  std::uint64_t memory = 0;                // bytes of the planner's block; 0: by the robot's size, as much as there is
  std::uint64_t iterations = 1'000'000;    // expansions, at most
  bool clock_counts_instructions = false;  // under an emulator whose clock advances 1 ns an instruction
};

// Reads `--robot MODEL[:N] --seed S --memory B[K|M] --iterations N --icount` for a program that plans for `model`,
// which has trailers or not. Gives null, or what is wrong. The words must stay.
const char* parse(int count, const char* const* words, const char* model, bool has_trailers, Request& request);

}  // namespace krait::firmware
