// SPDX-License-Identifier: Apache-2.0
#include "host/picture/poses.hpp"

#include <cmath>

namespace krait::host {

namespace {

double hitch_length(const RobotSpec& robot) {
  const auto found = robot.parameters.find("hitch_length");
  if (found == robot.parameters.end()) {
    throw InputError("robot.parameters.hitch_length is missing: a robot with trailers needs it");
  }
  return found->second;
}

}  // namespace

std::size_t state_size(const RobotSpec& robot) { return state_names(robot).size(); }

std::vector<Pose> body_poses(const RobotSpec& robot, std::span<const float> state) {
  std::vector<Pose> poses = {{state[0], state[1], state[2]}};
  if (robot.links == 0) return poses;
  const double hitch = hitch_length(robot);
  const auto trailers = static_cast<std::size_t>(robot.links);
  const std::span<const float> headings = state.subspan(state_size(robot) - trailers);  // behind the front's
  for (std::size_t i = 0; i < trailers; ++i) {
    const double heading = headings[i];
    const Pose ahead = poses.back();
    poses.push_back({ahead.x - hitch * std::cos(heading), ahead.y - hitch * std::sin(heading), heading});
  }
  return poses;
}

}  // namespace krait::host
