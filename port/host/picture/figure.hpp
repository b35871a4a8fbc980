// SPDX-License-Identifier: Apache-2.0
// The parts that the still pictures and the page have in common: checks, captions, sizes.
#pragma once

#include <string>
#include <vector>

#include "host/picture/picture.hpp"

namespace krait::host {

inline constexpr double kMargin = 28;  // points, around what is drawn

// Throws InputError with one line that names what is wrong: see Picture.
void check(const Picture& picture);

// The text as a drawing may show it: escaped (safe_to_print), at most 200 characters, U+FFFD for those that XML lacks.
std::string printable(const std::string& text);

// Facts about the plan, for the line below the title: robot, planner, seed, status, duration, length.
std::vector<std::string> facts(const Picture& picture);

// 1, 2 or 5 times a power of ten, at most `limit` (which is positive).
double round_length(double limit);

// A number without trailing zeros: "0.5", "20".
std::string short_number(double value);

// A line that is an arrow around the goal's middle for each heading that is accepted there, scene coordinates.
std::vector<Ring> goal_arrows(const PlanFile& plan);

// A line that is a chevron pointing ahead, in the frame of the first body and inside of it where that is a box; empty
// for a robot without bodies.
Ring front_mark(const RobotSpec& robot);

// The sheet of a still picture: the map with a head above and a legend below. One unit is a point; a PNG has
// kPixelsPerPoint pixels each.
inline constexpr int kPixelsPerPoint = 2;

struct Figure {
  double width = 0;  // of the sheet, a whole number
  double height = 0;
  double left = 0;  // the map
  double top = 0;
  double map_width = 0;
  double map_height = 0;
  double scale = 0;  // points a metre
  Point min, max;    // metres

  // Where a point of the scene lies on the sheet.
  Point at(Point local) const;
};

Figure layout(const Picture& picture);

}  // namespace krait::host
