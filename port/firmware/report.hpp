// SPDX-License-Identifier: Apache-2.0
// The output of a firmware: one line of JSON, and the exit code.
#pragma once

#include <cstdint>

#include "firmware/board.hpp"
#include "firmware/request.hpp"
#include "firmware/why.hpp"
#include "krait/planner.hpp"
#include "krait/status.hpp"

namespace krait::firmware {

// The exit codes of the program krait.
inline constexpr int kDone = 0;
inline constexpr int kHonestNo = 1;
inline constexpr int kBadInput = 2;
inline constexpr int kOwnBug = 3;

int exit_code(Status status);

// What was made of the first plan.
struct Improvement {
  std::uint32_t first_steps = 0;
  float first_length = 0.0F;      // metres
  float first_duration = 0.0F;    // seconds
  std::uint64_t iterations = 0;   // of looking for better ones
  std::uint64_t nanoseconds = 0;  // of all iterations
  std::uint64_t slowest = 0;      // of the longest one
};

struct Report {
  Failure failure;
  const char* scene = "";         // its name
  Statistics statistics;          // of the search, but of the best plan
  std::uint64_t nanoseconds = 0;  // from opening the scene to the first plan
  std::uint64_t setup = 0;        // nanoseconds of those before the first expansion
  std::uint64_t slowest = 0;      // nanoseconds of the longest expansion
  Improvement improvement;
  Why why;  // filled where there is no plan, unless the firmware is built with KRAIT_REASONS=OFF
};

// Says in one line why there is no plan, if there is none, then writes the line of JSON. Returns the exit code.
int write(const Board& board, const Request& request, const Report& report);

// Says what is wrong with the command line: the complaint, what it is about, and what more there is to it. Returns the
// exit code.
int refuse(const Board& board, const char* complaint, const char* about = "", const char* more = "");

}  // namespace krait::firmware
