// SPDX-License-Identifier: Apache-2.0
// The query and the parameters of one run, from the words of a command line.
#pragma once

#include <cstdint>

#include "krait/goal.hpp"
#include "krait/parameters.hpp"

namespace krait::firmware {

// Three numbers with commas between them: the place in the world, metres, and a third.
struct Triple {
  double x = 0.0;
  double y = 0.0;
  double third = 0.0;
};

struct Request {
  const char* robot = "";    // "snake:15", "truck:2", "car", …
  const char* unknown = "";  // the word that is no option, after kUnknownOption
  int trailers = 0;          // the number after the colon
  std::uint64_t seed = 1;    //
  std::uint64_t memory = 0;  // bytes of the planner's block; 0: by the robot's size, as much as there is
  std::uint64_t iterations = Limits().iterations;  // expansions, at most
  double improve = 0.0;                            // multiples of the first plan's collision checks to improve it by
  bool clock_counts_instructions = false;          // under an emulator whose clock advances 1 ns an instruction
  bool has_start = false;
  bool has_goal = false;
  bool has_heading = false;
  bool has_heading_tolerance = false;
  bool has_clearance = false;
  bool has_dt = false;
  Triple start;          // and the heading, radians; without it, the scene's first start
  Triple goal;           // and the radius, metres; without it, the scene's first goal
  double heading = 0.0;  // radians: of body 0 at the end, with `goal` only
  double heading_tolerance = static_cast<double>(Facing().tolerance);  // radians
  double clearance = 0.0;                                              // metres; without it, the library's default
  double dt = 0.0;  // seconds, a time step; without it, the library's default
};

inline constexpr char kAnotherRobot[] = "--robot: this firmware plans for another robot, ";  // whose name is to follow

inline constexpr char kUnknownOption[] = "unknown option: ";  // whose word and kKnownOptions are to follow
inline constexpr char kKnownOptions[] =
    "; known are --robot, --seed, --memory, --iterations, --improve, --start, --goal, --heading, --heading-tolerance, "
    "--clearance, --dt and --icount";

// Reads `--robot MODEL[:N] --seed S --memory B[K|M] --iterations N --improve N --start X,Y,HEADING --goal X,Y,RADIUS
// --heading H --heading-tolerance T --clearance C --dt S --icount` for a program that plans for `model`, which has a
// number of trailers to ask for or not. Returns null, or what is wrong: kAnotherRobot itself for a robot of another
// name, kUnknownOption itself for what is no option. The words must stay.
const char* parse(int count, const char* const* words, const char* model, bool has_trailers, Request& request);

}  // namespace krait::firmware
