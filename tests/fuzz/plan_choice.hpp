// SPDX-License-Identifier: Apache-2.0
// The first bytes of an input of fuzz_plan: what is planned in the scene that follows them, and how the search is led
// into its corners.
#pragma once

#include <cstdint>
#include <string_view>

#include "krait/robots/all.hpp"

namespace krait::fuzz {

inline constexpr const char* kRobots[] = {"unicycle", "car",     "diff_drive", "snake:2",
                                          "truck:1",  "snake:6", "unicycle2",  "kinematic_truck:1"};
// Inputs choose by the place in this list: a new model stands at its end.
constexpr bool is_drawn(std::string_view model) {
  for (const std::string_view robot : kRobots) {
    if (robot.substr(0, robot.find(':')) == model) return true;
  }
  return false;
}
#define KRAIT_DRAWN(name, Class, file, trailers) static_assert(is_drawn(#name));
KRAIT_MODELS(KRAIT_DRAWN)
#undef KRAIT_DRAWN

inline constexpr const char* kPlanners[] = {"adaptive", "plain", "prior", "rrt"};

struct PlanChoice {
  std::uint8_t robot = 0;        // of kRobots
  std::uint8_t planner = 0;      // of kPlanners
  std::uint8_t seed = 1;         // of the search
  std::uint8_t parameters = 0;   // bit 0: the paper's; bit 1: plans may end at any speed
  std::uint8_t memory = 0xFF;    // low five bits: KB over 1, doubled as often as the others say
  std::uint8_t restarts = 0;     // the unit is halved so often, down to none
  std::uint8_t goal = 0;         // bit 0: a pose in the scene's first goal; 1: either way round; 2: straight hitches;
                                 // the others: its heading, in 32nds of a turn
  std::uint8_t improvement = 0;  // in 64ths of the first plan's collision checks

  bool paper() const { return (parameters & 1U) != 0; }
  bool at_any_speed() const { return (parameters & 2U) != 0; }
  std::uint64_t bytes() const { return std::uint64_t{1U + memory % 32U} * 1024 << memory / 32U; }
  bool pose() const { return (goal & 1U) != 0; }
};

}  // namespace krait::fuzz
