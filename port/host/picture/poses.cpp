// SPDX-License-Identifier: Apache-2.0
#include "host/picture/poses.hpp"

#include <cmath>

namespace krait::host {

namespace {

constexpr std::size_t kFirstTrailerAngle = 5;  // x y theta0 v psi theta1 ...

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
  for (std::size_t i = 0; i < static_cast<std::size_t>(robot.links); ++i) {
    const double heading = state[kFirstTrailerAngle + i];
    const Pose ahead = poses.back();
    poses.push_back({ahead.x - hitch * std::cos(heading), ahead.y - hitch * std::sin(heading), heading});
  }
  return poses;
}

}  // namespace krait::host
