// SPDX-License-Identifier: Apache-2.0
// What an importer yields and everything else on the workstation reads: a map in metres, double precision.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/workspace/text.hpp"

namespace krait::host {

struct Point {
  double x = 0;
  double y = 0;
};

using Ring = std::vector<Point>;  // closed implicitly; either orientation

struct Obstacle {
  std::string label;  // as a user would find it in the file: "obstacles[3]", "environment.obstacles[0]"
  Ring outer;         // may be non-convex, overlap others, lie partly outside the bounds
  std::vector<Ring> holes;
};

// How the robot is turned where a plan ends, radians.
struct GoalFacing {
  double heading = 0;                            // of the first body
  double tolerance = 0.1;                        // above 0 and at most pi: how far off the heading may be
  bool either_way = false;                       // whether the opposite heading is accepted as well
  std::optional<double> hitches = std::nullopt;  // every other body's heading is so near to that of the body before it;
                                                 // absent: free
};

// A place to end at and how to be turned there.
struct GoalPose {
  Point position;
  double radius = 0;  // metres: how near to the position is there
  GoalFacing facing;
};

struct Goal {
  std::string name;
  Ring polygon;                                 // of a pose: inside its disc
  std::optional<GoalPose> pose = std::nullopt;  // absent: anywhere in the polygon, turned in any way
};

inline constexpr int kMaxLinks = 25;  // trailers of a robot, and so angles of a start

struct Start {
  std::string name;
  Point position;
  double heading = 0;
  std::vector<double> angles;  // trailer headings; empty: all equal to heading
};

// A map of square cells. Cell (column, row) covers [column, column + 1] x [row, row + 1] * resolution in the
// map's own frame (row 0 at the bottom), which is placed in the world by origin and yaw.
struct CellMap {
  int columns = 0;
  int rows = 0;
  double resolution = 0;               // metres
  Point origin;                        // world position of the corner of cell (0, 0)
  double yaw = 0;                      // radians, counter-clockwise
  std::vector<std::uint8_t> occupied;  // rows * columns, row-major from the bottom row: 1 = obstacle

  bool at(int column, int row) const {
    return occupied[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column)] != 0;
  }
};

// Metres that a passage may be asked to get narrower by: twice what a scene file can say that obstacles grew.
inline constexpr double kMostTolerance = 4000;

struct Workspace {
  std::string name;
  Point min;  // the bounds, world coordinates
  Point max;
  std::vector<Obstacle> obstacles;
  std::optional<CellMap> cells;  // a map's obstacles are its occupied cells, in addition to `obstacles`
  std::vector<Goal> goals;
  std::vector<Start> starts;
  Point shift;  // whole metres: the file's coordinates less these are the workspace's; not 0 for maps far from 0 only
  std::vector<std::string> files;     // that it was read from: the map's own, its image's
  std::vector<std::string> warnings;  // one line each, for the user, safe to print
};

// Unusable input: one line that says what, where and what to do. The command line prints it and exits with 2. What the
// line quotes of names, files and arguments is safe to print, whatever they hold.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& line) : std::runtime_error(safe_to_print(line)) {}
};

}  // namespace krait::host
