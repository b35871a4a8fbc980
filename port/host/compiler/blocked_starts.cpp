// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/blocked_starts.hpp"

#include "host/run/standing.hpp"

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
