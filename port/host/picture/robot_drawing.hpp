// SPDX-License-Identifier: Apache-2.0
// Draws a robot to scale: bodies, axles, hitches, the reference point, and its sizes in metres.
#pragma once

#include <string>
#include <vector>

#include "host/robot_file/robot_file.hpp"

namespace krait::host {

// A turn to the left as it is drawn: the bodies around (0, radius), body 0 at the origin with heading 0; metres.
struct TurnPicture {
  double radius = 0;  // of the middle of body 0's axle
  double inner = 0;   // of the ring that the bodies sweep
  double outer = 0;   // more than 0
  std::vector<Ring> bodies;
};

struct RobotPicture {
  std::string title;
  RobotSpec robot;  // as read_robot returns it
  TurnPicture turn;
  std::vector<std::string> lines;  // of text, below the title
};

// Each throws InputError where Cairo fails. The same picture has the same bytes on one machine.
std::string draw_robot_svg(const RobotPicture& picture);
std::string draw_robot_png(const RobotPicture& picture);  // the bytes of the file

}  // namespace krait::host
