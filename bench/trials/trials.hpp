// SPDX-License-Identifier: Apache-2.0
// What every benchmark program does: answer trials. A trial is a line of JSON on standard input; its answer, a line on
// standard output, has the outcome, the time, and what the verifier found.
//
//   {"trial": 7, "seed": 7, "scene": "rooms.krait", "input": "rooms.json", "robot": "car", "planner": "adaptive",
//    "set": {"alpha": 4}, "limit_s": 5, "start": [x, y, heading], "goal": [x, y, radius]}
//
// "input" is what the scene was compiled from: the verifier reads it. "robot" is as krait plan has it. "set", "start"
// and "goal" may be absent; coordinates are the world's, metres and radians.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <string>

#include "host/run/run.hpp"

namespace krait::bench {

struct Trial {
  std::string scene;  // path
  std::string input;  // path
  std::map<std::string, double> settings;
  host::SearchRequest request;  // with the robot, planner, seed, limit, start and goal
};

// Plans and stops the clock; throws host::InputError where start or goal cannot be used.
using Solve = std::function<host::SearchResult(const host::SceneBytes& scene)>;

// What solves the trial, which outlives it; throws host::InputError for a planner or settings that there are not.
using Choose = std::function<Solve(const Trial& trial)>;

enum class Verify { yes, no };

// Answers trials until standard input ends. Scenes and inputs are read once each, before any clock starts. A plan
// counts as verified only if the verifier, given the input's own map, finds no fault; with Verify::no nobody looks,
// which is for counting the instructions of trials whose plans were verified before. "waited_s" is how long the thread
// stood ready without a processor: large where something else ran on its core. Throws host::InputError for a line that
// cannot be used.
void answer_trials(const Choose& choose, Verify verify);

// Parses, which runs the subcommand's callback, and returns the exit code: 0, 2 for bad input.
int run_program(CLI::App& app, int argc, char** argv);

// What the measurements depend on beside the machine, as a line: {"compiler": …, "flags": …, "build_type": …} and the
// versions of libraries by their names.
void print_build(const std::map<std::string, std::string>& libraries = {});

}  // namespace krait::bench
