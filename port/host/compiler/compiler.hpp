// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles a workspace into the bytes of a scene file (include/krait/FORMAT.md).
// GPL-3.0-or-later, as CGAL's triangulation packages are; linked into krait-compile only.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/workspace/workspace.hpp"

namespace krait::host {

// Metres around each start where no obstacle grows by the default tolerance, so that a robot that stands free there
// does in the scene.
inline constexpr double kStartReach = 5;

struct CompileOptions {
  // Metres that simplification may narrow a passage by. Negative: 0 for drawings; for maps one cell, of passages that
  // stay two cells wide, and nothing within kStartReach of a start.
  double tolerance = -1;
  std::function<void(const std::string&)> progress;  // told the name of each step as it begins; may be empty
  // Triangles may be slender: some half as many, so that flash and memory are smaller, and the search is guided by
  // less.
  bool coarse = false;
  double grown = 0;  // metres that the workspace's obstacles have grown before; the scene's tolerance holds them, too
};

struct CompiledScene {
  std::vector<std::uint8_t> bytes;
  std::vector<std::string> warnings;  // one line each
};

// Throws InputError with one line naming the obstacle or goal that cannot be made sound.
CompiledScene compile(const Workspace& workspace, const CompileOptions& options);

}  // namespace krait::host
