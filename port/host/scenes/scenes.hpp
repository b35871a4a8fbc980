// SPDX-License-Identifier: Apache-2.0
// The six scenes that krait ships: 50 m x 50 m, walls 1 m thick, passages of 1.4 m that a robot fits through and of
// 0.4 m that it does not, a goal of 3 m x 3 m. All but `streets` are drawn after the paper's figures 1 and 3.
#pragma once

#include <string>
#include <vector>

#include "host/workspace/workspace.hpp"

namespace krait::host {

inline constexpr double kMinSceneScale = 0.5;
inline constexpr double kMaxSceneScale = 8;

// A gap in a wall: the part of the wall's rectangle that is left free.
struct Passage {
  Point min;
  Point max;
  double width;  // m
  bool passable;
};

struct Scene {
  Workspace workspace;            // one goal "goal", one start "start" with 20.5 m of free floor straight behind it
  std::vector<Passage> passages;  // none in `corridors` and `streets`
};

struct SceneName {
  const char* name;
  const char* description;  // a line
};

// In the order of the documentation: openings, gates, rooms, comb, corridors, streets.
const std::vector<SceneName>& scene_names();

// The scale multiplies every position and room; widths of passages, walls, aisles, streets and the goal stay. Throws
// InputError for an unknown name or a scale outside kMinSceneScale…kMaxSceneScale.
Scene make_scene(const std::string& name, double scale);

// The scene as native JSON (port/host/README.md, "Files").
std::string scene_json(const std::string& name, double scale);

}  // namespace krait::host
