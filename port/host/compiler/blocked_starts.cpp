// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/blocked_starts.hpp"

#include "decomposition/locate.hpp"
#include "host/run/standing.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

std::optional<std::string> why_blocked(const krait::Scene& scene, const SearchRequest& request) {
  try {
    return why_it_cannot_start(scene, request);
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

std::vector<std::string> starts_in_obstacles(const CompiledScene& compiled) {
  const SceneBytes bytes = SceneBytes::copy(compiled.bytes.data(), compiled.bytes.size());
  const krait::Scene scene = open_scene("the compiled scene", bytes);
  const float grown = scene.header().tolerance;
  const std::string remedy =
      grown > 0
          ? printed(" (obstacles are grown by up to %.4g m: --tolerance 0 leaves them as they are)", decimal(grown))
          : "";
  std::vector<std::string> lines;
  for (Index i = 0; i < scene.start_count(); ++i) {
    const Vec2 at = scene.start(i).position;
    if (!scene.inside_bounds(at) || detail::locate(scene, at) != kNone) continue;
    lines.push_back("start '" + std::string(scene.start_name(i)) + "' lies in an obstacle: no plan can begin there" +
                    remedy);
  }
  return lines;
}

std::vector<std::string> blocked_starts(const CompiledScene& compiled, const RobotSpec& robot) {
  const SceneBytes bytes = SceneBytes::copy(compiled.bytes.data(), compiled.bytes.size());
  const krait::Scene scene = open_scene("the compiled scene", bytes);
  std::vector<std::string> lines;
  SearchRequest request;
  request.robot = robot;
  for (Index i = 0; i < scene.start_count(); ++i) {
    request.start_name = scene.start_name(i);
    const std::optional<std::string> why = why_blocked(scene, request);
    if (why) lines.push_back("the robot of --for cannot begin at start '" + request.start_name + "': " + *why);
  }
  return lines;
}

}  // namespace krait::host
