// SPDX-License-Identifier: GPL-3.0-or-later
// What the campaign plans: scenes, and in each robots of every accepted size, speed and step that it might hold.
#pragma once

#include "host/workspace/workspace.hpp"
#include "planning.hpp"

namespace krait::campaign {

struct DrawnScene {
  host::Workspace workspace;
  double passage = 1;  // m: a width that robots may have to pass
};

// A random workspace, or a shipped scene at a scale from 0.25 to 16.
DrawnScene draw_scene(std::uint64_t seed);

// The query of this number in the scene: starts are drawn until one is free in the field, if one is found.
struct DrawnQuery {
  Query query;
  Region goal;
};
DrawnQuery draw_query(const DrawnScene& drawn, const Scene& scene, const Field& field, std::uint64_t seed, int number);

// All that a report needs of a query, on one line.
std::string describe(const Query& query);

}  // namespace krait::campaign
