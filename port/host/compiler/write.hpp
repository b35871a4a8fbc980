// SPDX-License-Identifier: GPL-3.0-or-later
// Lays out a scene file (include/krait/FORMAT.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/compiler/frame.hpp"
#include "host/compiler/goals.hpp"
#include "host/compiler/mesh.hpp"

namespace krait::host::compiler {

struct SceneParts {
  Frame frame;
  Mesh mesh;
  std::vector<PlacedGoal> goals;
  std::vector<GridRing> pieces;
  Edges free_boundary;        // between the free space and everything else
  double obstacle_error = 0;  // metres
  double growth = 0;          // metres
};

std::vector<std::uint8_t> write_scene(const Workspace& workspace, const SceneParts& parts);

}  // namespace krait::host::compiler
