// SPDX-License-Identifier: GPL-3.0-or-later
// The finest scene of a map that fits a machine.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "host/compiler/compiler.hpp"
#include "host/robot_file/robot_file.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

struct Budget {
  std::uint64_t flash = 0;  // bytes of the scene file; 0: any number
  std::uint64_t ram = 0;    // bytes of the planner's block, with room for kFitVertices vertices; 0: any number
  // Metres that a passage may get narrower by; negative: as much as krait plan's usual clearance.
  double tolerance = -1;
  bool coarse = false;  // coarse regions in every step
};

inline constexpr std::uint32_t kFitVertices = 1000;

struct Fitted {
  CompiledScene scene;
  std::vector<std::string> report;  // what was done, the error in metres, the bytes; lines to print
};

// Compiles the workspace by steps, each coarser than the one before:
//   1. its outlines as they are, and simplified by up to the error E that is allowed, half the tolerance;
//   2. the same with coarse regions;
//   3. the same in larger cells, half of E for these and half for the outlines, where that makes cells twice as large;
//   4. the same as the last of 2 within corridors around the ways from the starts to the goals, 32 to 2 times as wide
//      as the robot's bodies reach from their middles.
// Begins with the coarsest, since its compilation is the shortest, and returns the last one that fits; where one takes
// four times the budget, those that are finer in every way are not tried. Steps that leave the robot no way from
// the first start to the first goal are passed over. 3 and 4 need a map of cells, 4 a start and a goal. The
// scene's warnings name the passages and goals that 3 and 4 close; its tolerance is the whole error of the step. Throws
// InputError with the bytes where no step fits.
Fitted fit(const Workspace& workspace, const RobotSpec& robot, const Budget& budget,
           const std::function<void(const std::string&)>& progress);

}  // namespace krait::host
