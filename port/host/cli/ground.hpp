// SPDX-License-Identifier: Apache-2.0
// What krait plan searches in: a compiled scene, or a map that it compiles.
#pragma once

#include <optional>
#include <string>

#include "host/cli/plan_options.hpp"
#include "host/input/progress.hpp"
#include "host/run/run.hpp"
#include "host/workspace/workspace.hpp"

namespace krait::host {

// The last word of krait plan before its search.
inline constexpr const char* kStoppedEarly = "krait: stopped by you before the search: nothing is written\n";

// The scene to plan in and, where the user names a map and no compiled scene, that map.
struct Ground {
  SceneBytes scene;
  std::optional<Workspace> map;
  double grown = 0;  // metres a side, by which obstacles were grown and then were not, since nothing else left a way
};

// Reads the file that the options name, and compiles it where it is a map. The request's goal becomes the map's where
// that is a pose. Throws InputError for whatever cannot be used, also for an output that would overwrite a file that
// the map names.
Ground read_ground(const PlanOptions& options, SearchRequest& request, Progress& progress);

// Compiles the ground's map once more, with obstacles as they are drawn. `growth` is by how much, in metres, they were
// grown before.
void compile_exactly(Ground& ground, const PlanOptions& options, double growth);

}  // namespace krait::host
