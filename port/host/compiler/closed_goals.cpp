// SPDX-License-Identifier: GPL-3.0-or-later
#include "host/compiler/closed_goals.hpp"

#include "host/compiler/blocked_starts.hpp"
#include "host/run/pools.hpp"
#include "host/run/robots.hpp"
#include "host/run/session.hpp"
#include "host/run/standing.hpp"
#include "host/run/why.hpp"

namespace krait::host {
namespace {

// Where none of it is free the compiler has warned of that.
bool has_free_part(const krait::Scene& scene, Index goal) {
  for (Index triangle = 0; triangle < scene.triangle_count(); ++triangle) {
    if (scene.goal_of(triangle) == goal) return true;
  }
  return false;
}

}  // namespace

std::optional<std::string> why_closed(const krait::Scene& scene, const RobotSpec& robot, Index goal) {
  SearchRequest request;
  request.robot = robot;
  request.memory = least_block(scene, CoreRobot(robot).view());
  request.goal_name = scene.goal_name(goal);
  if (scene.start_count() == 0 || why_blocked(scene, request)) return std::nullopt;
  try {
    Block block = block_of(request);
    const std::unique_ptr<Session> session = start_session(scene, request, block);
    if (session->status() == Status::no_route) return why_no_plan(*session, scene, request).front();
    return why_it_never_ends(scene, request);
  } catch (const InputError& error) {
    return error.what();
  }
}

std::vector<std::string> closed_goals(const CompiledScene& compiled, const RobotSpec& robot) {
  const SceneBytes bytes = SceneBytes::copy(compiled.bytes.data(), compiled.bytes.size());
  const krait::Scene scene = open_scene("the compiled scene", bytes);
  std::vector<std::string> lines;
  for (Index i = 0; i < scene.goal_count(); ++i) {
    if (!has_free_part(scene, i)) continue;
    if (const std::optional<std::string> why = why_closed(scene, robot, i))
      lines.push_back("the robot of --for cannot come to goal '" + std::string(scene.goal_name(i)) + "': " + *why);
  }
  return lines;
}

}  // namespace krait::host
