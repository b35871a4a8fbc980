// SPDX-License-Identifier: Apache-2.0
// Many seeds of one query, planned in this process, each plan judged by the verifier against the input itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "host/import/import.hpp"
#include "host/run/run.hpp"

namespace krait::host {

// `quick` seeds, or `thorough` where the environment has KRAIT_LONG_TESTS=1.
std::uint64_t seeds(std::uint64_t quick, std::uint64_t thorough);

struct Query {
  std::string input;     // path of the map or scene as the user has it
  std::string compiled;  // path of its .krait
  ImportOptions import;
  RobotSpec robot;
  std::optional<StartPose> start;  // absent: the input's first
  std::optional<GoalDisc> goal;    // absent: the input's first
};

// Compiles query.input to query.compiled with the program, expecting success.
void compile_input(const Query& query, const std::filesystem::path& directory);

// Plans with seeds 1 … count, expects every one solved and verified, and prints the median and 90th percentile of time
// and vertices and the worst margins of the verifier.
void expect_all_solved(const std::string& title, const Query& query, std::uint64_t count);

}  // namespace krait::host
