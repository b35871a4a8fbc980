// SPDX-License-Identifier: Apache-2.0
// The colours of a picture, and how a heuristic cost becomes one: red near the goal, blue far, by way of pale yellow,
// so that lightness tells the two halves apart for readers who do not see red and green as different.
#pragma once

#include <cstdint>
#include <vector>

namespace krait::host {

struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};

inline constexpr Color kInk = {0x17, 0x1b, 0x22};    // text and outlines
inline constexpr Color kFaint = {0x5b, 0x62, 0x6e};  // secondary text
inline constexpr Color kPaper = {0xff, 0xff, 0xff};  // the page
inline constexpr Color kFree = {0xf1, 0xf0, 0xec};   // free space without costs
inline constexpr Color kObstacle = {0x3a, 0x41, 0x4d};
inline constexpr Color kCutOff = {0xb9, 0xbd, 0xc4};  // a region from which no path leads to the goal
inline constexpr Color kGoal = {0xff, 0xd5, 0x1f};
inline constexpr Color kRobot = {0xff, 0xff, 0xff};  // the bodies between start and end
inline constexpr Color kRobotStart = {0x8f, 0xe3, 0xc8};
inline constexpr Color kRobotEnd = {0x6a, 0x2c, 0xa8};

// Costs are shown in 255 levels; level 255 stands for an infinite cost.
inline constexpr int kLevels = 255;
inline constexpr std::uint8_t kInfiniteLevel = 255;

// The colour of a level: 0 (at the goal) is red, kLevels - 1 blue, kInfiniteLevel grey.
Color level_color(std::uint8_t level);

// The cost that is shown bluest: the largest finite one, unless a few outliers (2 % of the regions) exceed all
// others by half, which would leave one hue to the rest. 0 if no cost is finite or all are 0.
double top_cost(const std::vector<float>& costs);

// The level of a cost, 0 .. kLevels - 1, linear up to `top` and constant above it; kInfiniteLevel if infinite.
std::uint8_t cost_level(float cost, double top);

}  // namespace krait::host
