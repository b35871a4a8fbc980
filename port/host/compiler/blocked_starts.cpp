// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/blocked_starts.hpp"

#include "decomposition/locate.hpp"
#include "host/run/standing.hpp"
#include "host/workspace/printed.hpp"

namespace krait::host {
namespace {

// A line for each start of which `why` tells one, of the scene and the start's number.
template <class Why>
std::vector<std::string> lines_of_starts(const CompiledScene& compiled, const Why& why) {
  const SceneBytes bytes = SceneBytes::copy(compiled.bytes.data(), compiled.bytes.size());
  const krait::Scene scene = open_scene("the compiled scene", bytes);
  std::vector<std::string> lines;
  for (Index i = 0; i < scene.start_count(); ++i) {
    if (std::optional<std::string> line = why(scene, i)) lines.push_back(*std::move(line));
  }
  return lines;
}

std::optional<std::string> why_in_obstacle(const krait::Scene& scene, Index start, bool asked) {
  const Vec2 at = scene.start(start).position;
  if (!scene.inside_bounds(at) || detail::locate(scene, at) != kNone) return std::nullopt;
  const std::string line =
      "start '" + std::string(scene.start_name(start)) + "' lies in an obstacle: no plan can begin there";
  if (!asked) return line;
  return line + printed(" (obstacles are grown by up to %.4g m: --tolerance 0 leaves them as they are)",
                        decimal(scene.header().tolerance));
}

}  // namespace

std::optional<std::string> why_blocked(const krait::Scene& scene, const SearchRequest& request) {
  try {
    return why_it_cannot_start(scene, request);
  } catch (const InputError& error) {
    return error.what();
  }
}

std::vector<std::string> starts_in_obstacles(const CompiledScene& compiled, bool asked) {
  return lines_of_starts(compiled,
                         [asked](const krait::Scene& scene, Index i) { return why_in_obstacle(scene, i, asked); });
}

std::vector<std::string> blocked_starts(const CompiledScene& compiled, const RobotSpec& robot) {
  SearchRequest request;
  request.robot = robot;
  return lines_of_starts(compiled, [&](const krait::Scene& scene, Index i) -> std::optional<std::string> {
    request.start_name = scene.start_name(i);
    const std::optional<std::string> why = why_blocked(scene, request);
    if (!why) return std::nullopt;
    return "the robot of --for cannot begin at start '" + request.start_name + "': " + *why;
  });
}

}  // namespace krait::host
