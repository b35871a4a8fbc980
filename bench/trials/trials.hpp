// SPDX-License-Identifier: Apache-2.0
// What every benchmark program does: answer trials. A trial is a line of JSON on standard input; its answer, a line on
// standard output, tells the outcome, the time, and what the verifier found.
//
//   {"trial": 7, "seed": 7}
//   {"trial": 12, "seed": 1, "start": [x, y, heading], "goal": [x, y, radius]}      world coordinates, metres, radians
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "host/run/run.hpp"

namespace krait::bench {

// What all trials of a process share.
struct Setup {
  std::string scene;  // a .krait file
  std::string input;  // what it was compiled from: the verifier reads it
  std::string robot = "snake:15";
  std::string planner;
  double time_limit = 100;  // seconds a trial
};

// Plans and stops the clock; throws host::InputError where start or goal cannot be used.
using Solve = std::function<host::SearchResult(const host::SearchRequest& request)>;

// Adds the options of a Setup.
void add_options(CLI::App& app, Setup& setup);

// Answers trials until standard input ends. A plan counts as verified only if the verifier, given the input's own map,
// finds no fault. Throws host::InputError for a setup or a line that cannot be used.
void answer_trials(const Setup& setup, const Solve& solve);

// Parses, which runs the subcommand's callback, and returns the exit code: 0, 2 for bad input.
int run_program(CLI::App& app, int argc, char** argv);

// What the measurements depend on beside the machine: {"compiler": …, "flags": …, "build_type": …}, a line.
void print_build();

}  // namespace krait::bench
